#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d {

/// Describes a file, or a collection of files, of a study whose graphs are instances, opened.
struct StudyCorpus {
  const Sweep* sweep = nullptr;        ///< of the specification
  const GraphsEntry* entry = nullptr;  ///< of that sweep
  GraphFileRecord record;
  std::shared_ptr<const Corpus> corpus;

  /// Returns the family and parameters of its instances, for each of the entry's shuffles.
  std::vector<FamilyChoice> choices() const;
};

/// Returns every file of the specification's `graphs`, in its order; those that a pattern matches
/// by name, and those of a collection as one. A study that has begun has the files that it began
/// with. Each is read once for all copies of the specification.
/// @param only  given: just the files called so.
/// @throws InputError naming the entry: a file that is missing or cannot be read, a pattern without
/// match, a name that a family of the catalogue or another file has, two files with the same
/// graphs; naming the file: one that has changed since the study began.
std::vector<StudyCorpus> corpora_of(const Study& study, const std::string& only = "");

/// Returns the files whose graphs are instances, not opened; none of a pattern that matches nothing
/// now.
std::vector<std::string> graph_files_of(const Study& study);

// The files themselves (collected_files.cpp).

bool is_pattern(const std::string& file);
[[noreturn]] void refuse_empty(const GraphsEntry& entry);
/// Returns what matches, by name (no folders); the path itself where it exists under that very name,
/// or is no pattern. Of a collection also everything in folders that match, except files that a
/// study has beside its graphs. A study looks once: it always gets this first list.
/// @throws InputError naming what cannot be read.
const std::vector<std::string>& listed_files(const StudyFiles& files, const std::string& path,
                                             bool is_collection);
/// Returns the files that are there now and were not when the study listed its collections.
std::vector<std::string> files_come_since(const StudyFiles& files);
/// Returns the files of a collection with their names behind its folder, and their groups:
/// sub-folders, or as the table says. @throws InputError as above, and naming a line of the table
/// that is none.
std::vector<CorpusFile> collected_files(const GraphFileRecord& record, const GraphsEntry& entry,
                                        const StudyFiles& files);

}  // namespace ar3d
