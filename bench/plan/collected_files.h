#pragma once

#include <string>
#include <vector>

#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d {

bool is_pattern(const std::string& file);
[[noreturn]] void refuse_empty(const GraphsEntry& entry);
/// Returns what matches, by name; the file itself where it exists under that very name, or is no
/// pattern.
std::vector<std::string> matches(const std::string& path);
/// Returns these without folders. @throws InputError if there are none.
std::vector<std::string> matching_files(const std::string& path, const GraphsEntry& entry);
/// Returns the files of a collection, by name: what matches, and everything in folders that match,
/// but for the study's own files and journals (StudySpec::own_files).
/// @throws InputError naming what cannot be read.
std::vector<std::string> collected_paths(const std::string& path,
                                         const std::vector<std::string>& own_files);
/// Returns the files of a collection with their names behind its folder, and their groups:
/// sub-folders, or as the table says. @throws InputError as above, and naming a line of the table
/// that is none.
std::vector<CorpusFile> collected_files(const GraphFileRecord& record, const GraphsEntry& entry,
                                        const std::vector<std::string>& own_files);

}  // namespace ar3d
