#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "ar3d/bench/run/session.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/rows.h"
#include "options.h"

namespace ar3d {

/// Adds verbs of `ar3d study` that have files of their own.
void add_study_status(CLI::App& study, int& exit_code);
void add_study_plan(CLI::App& study, int& exit_code);
void add_study_count(CLI::App& study, int& exit_code);

/// Holds which study a verb is about: one of a name or a file, or graphs of files to be drawn.
struct StudyChoice {
  std::string study;
  std::uint64_t timed = 0;              ///< rounds of the timing phase; 0: as the study says
  std::vector<std::string> files;       ///< paths, patterns or folders, from the current one
  std::string name;                     ///< given: all files are one collection of this name
  std::string groups;                   ///< of the collection: table file -> group
  std::vector<std::string> algorithms;  ///< empty: all
  std::uint64_t seed = 0;
  std::uint64_t sample = 0;  ///< of each file; 0: all graphs
  bool skip = false;         ///< files that cannot be read are left out
  bool simple = false;       ///< loops and parallel edges are dropped
  bool largest_component = false;
  bool shuffle = false;
  bool count = false;
  ReadOptions reading;  ///< of every file: format, base and first line
};

/// Adds STUDY, --graphs and what goes with it.
void add_study_choice(CLI::App& verb, StudyChoice& choice);

/// Returns the study that was chosen. @throws InputError as load_study; unless exactly one of STUDY
/// and --graphs is given.
Study chosen_study(const StudyChoice& choice);

/// Refuses a study before any work that cannot be made with this policy (bad build, too few cores).
/// For large sizes and for rows with limits it estimates the cells, too. @throws InputError
/// @return what the plan does without, and what the machine lacks, in lines.
std::string refuse_impossible_study(const Study& study, const SessionPolicy& policy);

/// Returns the row with that key, or with that number from 0. @throws InputError naming the file if
/// there is none.
const RunRecord& find_row(const Results& results, const std::string& row, const std::string& path);

/// Draws rows again and writes their drawings. @param output  empty: RESULTS.drawings.jsonl.
/// @return the exit code. @throws InputError if a file cannot be read or must not be written.
int keep_drawings(const std::string& results, KeptDrawings kept, const std::string& output,
                  bool force);

/// Writes the drawings that a study keeps beside its results file, and prints where they are. What
/// stands there is replaced if it is a file of drawings or `force` is given; else nothing is
/// written. Where no row was made since (`unchanged`), a file of drawings stays as it is, too.
/// @return kPass, or kRegression if a drawing could not be kept, which is said on standard error.
int keep_drawings_beside(const std::string& results, const Rows& rows, KeptDrawings kept,
                         bool force, bool unchanged);

}  // namespace ar3d
