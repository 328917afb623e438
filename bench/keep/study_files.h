#pragma once

#include <string>
#include <vector>

#include "ar3d/base/new_file.h"
#include "ar3d/store/columns/study_identity.h"

namespace ar3d {

/// Returns "r.shard-2-of-8.h5" for r.h5; r.h5 itself if there is one shard.
std::string path_of_shard(const std::string& results, const Shard& shard);

/// Returns "r.h5.journal", and "r.h5.rank-3.journal" for a rank other than 0.
std::string journal_path(const std::string& results, int rank = 0);

/// Returns the path with its folder resolved (links, `.` and `..` followed), so that from now on it
/// leads to the same file whatever happens to the way there. A path without a folder, or with one
/// that is not there, stays as it is.
std::string in_resolved_folder(const std::string& path);

/// @throws InputError if the name is one that a journal or an unfinished file beside another
/// results file would have.
void require_results_name(const std::string& results);

/// Returns the journals of a study that exist, rank 0 first. Names are compared within the folder,
/// whatever the path to it. @throws InputError if the folder cannot be listed.
std::vector<std::string> existing_journals(const std::string& results);

/// Returns the page that a study's report is, beside its results file.
std::string report_path(const std::string& results);

/// Returns the file of the drawings that a study keeps, beside its results file: "r.drawings.jsonl"
/// for r.h5.
std::string drawings_path(const std::string& results);

/// Returns these three files of a study: results, report and drawings.
std::vector<std::string> own_files_of(const std::string& results);

/// Returns the results file that a journal is made into; other paths are results files themselves.
std::string results_path_of(const std::string& journal_or_results);

/// Returns true if there are no journals, or only some that a killed process has not removed any
/// more after it had made the results file. @throws InputError naming a journal that cannot be
/// read, or the folder if it cannot be listed.
bool rows_are_in_results(const std::string& results);

/// Removes what a killed process has left of a new results file, journal, report or file of
/// drawings (remove_leftovers). To be called by the one that has the journal locked. @throws
/// InputError if the folder cannot be listed.
void remove_study_leftovers(const std::string& results);

/// Opens the folder of a study's files: it stays the same one whatever its name becomes.
/// @throws InputError if it cannot be opened.
Descriptor open_folder(const std::string& results);
/// Returns the path of the results file in that folder: the one given as long as it leads there,
/// else the one under which the folder is found now.
std::string path_in_folder(const Descriptor& folder, const std::string& results);

/// Removes them; to be called once the results file is safe on the disk. @throws InputError naming
/// one that cannot be removed.
void remove_journals(const std::string& results);

}  // namespace ar3d
