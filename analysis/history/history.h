#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ar3d/analysis/history/cell_values.h"
#include "ar3d/analysis/history/change_points.h"

namespace ar3d {

/// A results file of a history, without its rows.
struct CommitResults {
  std::string file;         ///< its path
  std::int64_t place = 0;   ///< where it stands in the order: more is later
  std::string name;         ///< of the commit or release
  std::string source_hash;  ///< git commit of the program
  std::string study;
  std::string created;
  std::size_t environment = 0;  ///< in History::environments
  std::string untimed;          ///< why its times are not judged; empty: they are
  /// Holds how many times as long the short yardsticks took as in the median of the results of its
  /// environment: its times are divided by that. 1 without yardsticks.
  double slowness = 1;
  std::size_t unfinished = 0;  ///< rows
};

/// One measure of one cell over the commits, in one environment.
struct HistoryLine {
  std::size_t environment = 0;
  std::string study;
  HistoryCell cell;
  Measure measure = Measure::time;
  std::vector<std::size_t> results;  ///< in History::results, ascending, one a value
  std::vector<double> values;        ///< as CellValue::value, none missing
  std::vector<ChangePoint> changes;  ///< places among these values
  bool is_judged = true;  ///< false: too few values, or times of results that have all counts
};

struct HistoryRule {
  ChangeRule time;
  double instruction_threshold = 0.01;  ///< smaller changes of counted instructions do not matter
  double cycle_threshold = 0.05;        ///< of estimated cycles, which feel where data lie
};

struct History {
  std::vector<CommitResults> results;                            ///< by place, then name
  std::vector<std::map<std::string, std::string>> environments;  ///< lasting settings
  std::vector<HistoryLine> lines;  ///< by environment, study, cell, measure
  HistoryRule rule;

  std::size_t count(Measure measure, bool judged_only) const;
};

/// The name that a results file has in a history: PLACE_NAME_STUDY_ENVIRONMENT.h5, where
/// ENVIRONMENT stands for the lasting settings, so that results of two machines do not meet.
/// @param name  letters, digits, '.', '+' and '-'. @throws InputError naming it if it is not.
std::string history_file_name(std::int64_t place, const std::string& name,
                              const StudyIdentity& study,
                              const std::vector<EnvironmentEntry>& environment);

/// Reads every *.h5 of a folder and looks for changes. Lines hold results of one environment and
/// one study and of the same graphs, also where their file has been renamed (it is then called as
/// in the last results); times are divided by how slow the machine was (CommitResults::slowness),
/// and those of a busy machine without yardsticks, or of a debug or sanitised build, are left out;
/// where all results of a line of times have counts of the cell, the counts are judged and the
/// times are not. Memory: that of the cells. Cost: reading the files once, and find_changes per
/// line.
/// @throws InputError naming the folder if it has none, or the file that is no results file or
/// whose name does not begin with a place and a name.
History read_history(const std::string& folder, const HistoryRule& rule);

/// For a terminal: how much was judged, and every change with the commits around it and the command
/// that compares their results, `most` at most, the largest first.
std::string summary(const History& history, std::size_t most = 20);

/// The line that compares the results before a change with those behind it.
std::string compare_command(const History& history, const HistoryLine& line,
                            const ChangePoint& change);

/// "+10.2 % [+9.1 %, +11.3 %]", "1.5 to 1.6 per edge": what a change was.
std::string effect_text(const HistoryLine& line, const ChangePoint& change);

/// Everything, for programs: results, environments, lines with their values and changes.
std::string history_json(const History& history);

/// One HTML page; nothing is loaded from outside. Every cell has a line in its table; the
/// `kMostFigures` largest changes have figures. @param folder  as commands name it.
std::string render_history(const History& history, const std::string& folder);

/// A change with the line that it is on.
struct PlacedChange {
  const HistoryLine* line = nullptr;
  const ChangePoint* change = nullptr;
};

/// All changes, the largest effects first; those that are no ratio last.
std::vector<PlacedChange> changes_in_order(const History& history);

/// The results before the change (the last that surely have not got it, if `surely`) and behind it.
struct Neighbours {
  const CommitResults* before = nullptr;
  const CommitResults* after = nullptr;
};
Neighbours around(const History& history, const PlacedChange& placed, bool surely);

/// "+10.2 %" of a logarithm of a ratio.
std::string percent_change(double log_ratio);

/// "slower", "fewer instructions", "larger volume", …
const char* direction_text(const PlacedChange& placed);

/// The value with its unit: "1.23 ms", "4.5e+06", "2.31".
std::string value_text(Measure measure, double value);

}  // namespace ar3d
