#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "ar3d/store/columns/study_identity.h"

namespace ar3d {

/// Returns the first kilobytes of a file, where one of ours says what it is; nothing of what is no
/// regular file (a FIFO would be waited for) or cannot be read.
std::string beginning_of(const std::string& path);

/// Adds the option --force of every verb that writes files.
void add_force(CLI::App& verb, bool& force);

/// Describes the files of a verb, looked at before it does any work. An empty path stands for an
/// option that was left out, "-" for a standard stream: both are no file. Where no output may be
/// one, "-" is refused.
struct VerbFiles {
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;              ///< every one that will be written, but a page
  std::string page = {};                         ///< that can be made again at any time
  const char* page_is = "<title>ar3d report: ";  ///< what every such page has near its beginning
  bool force = false;                            ///< --force was given
  bool streams = true;                           ///< "-" as an output is standard output
};

/// Refuses to write over what is still needed:
/// - an output that is an input of the same verb, or another of its outputs, under whatever name
///   (links and `..` are followed);
/// - a journal, or the results file of a study that is not finished;
/// - unless --force is given, any file that exists and is not empty; but a page may be replaced by
///   another page of its kind, since it can be made again.
/// Devices and pipes are written to, not replaced. What killed processes left of these outputs is
/// removed (remove_leftovers).
/// @throws InputError naming the file and what it is.
void refuse_unsafe_outputs(const VerbFiles& files);

/// Makes a folder that is not there. @throws InputError naming it.
void make_folder(const std::string& path);

/// Writes to that file, or with "-" to standard output. @throws InputError
void write_json(const std::string& path, const std::string& text);

/// Refuses an ending that says another format than the file is written in.
/// @param own  endings that fit, the first of them to be advised. @throws InputError naming both.
void refuse_foreign_ending(const std::string& path, const std::vector<std::string>& own);

/// Returns what a row of a study is made from: its results file, the files of its graphs, and those
/// of its programs' commands that are files.
std::vector<std::string> files_of_study(const StudyIdentity& identity, const std::string& results);

/// Refuses to replace what is no report of ar3d by a report whose name was not given, since it
/// follows from that of the results. @throws InputError naming the file.
void refuse_foreign_page(const std::string& page, const std::string& results);

}  // namespace ar3d
