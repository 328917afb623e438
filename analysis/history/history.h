#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

#include "ar3d/analysis/compare/compare.h"
#include "ar3d/analysis/compare/file_times.h"
#include "ar3d/analysis/table.h"

namespace ar3d {

/// Says what a history follows of every cell.
enum class Measure : std::uint8_t { time, instructions, cycles, volume, bends, crossings, angle };
inline constexpr std::array kMeasures = {Measure::time,   Measure::instructions, Measure::cycles,
                                         Measure::volume, Measure::bends,        Measure::crossings,
                                         Measure::angle};
/// Returns "time", "instructions", "cycles", "volume", …
const char* to_string(Measure measure);

/// Describes a curve at one size with the very graphs that were drawn: values of other graphs are
/// another cell's.
struct HistoryCell {
  CurveKey curve;
  std::int64_t n = -1;
  std::string graphs;  ///< a hash of all of them
  friend auto operator<=>(const HistoryCell&, const HistoryCell&) = default;
};

/// Describes the measures of a cell in one results file.
struct CellValues {
  SideTimes times;  ///< of the timing phase if the cell has it
  /// Are geometric means over the graphs; of bends (per edge), crossings and the smallest angle in
  /// degrees arithmetic ones. Volumes are lattice points; of measured drawings they are in smallest
  /// distances of vertices. Missing is the time, and what a row of the cell has not.
  std::array<double, kMeasures.size()> means;
  /// Holds, of drawings, hashes of the values of every single graph; what is measured has three
  /// digits there.
  std::array<std::string, kMeasures.size()> exact;
  CellValues() { means.fill(kMissing); }
};

/// Holds times of one study in one environment, over its results in their order.
struct TimeSeries {
  std::vector<std::string> settings;              ///< which setting each cell is of
  std::vector<std::array<double, 3>> yardsticks;  ///< by result; logarithms, NaN: unknown
  std::vector<std::vector<SideTimes>> results;    ///< of all cells; 0 rounds: not timed
};

inline constexpr std::size_t kNoCell = static_cast<std::size_t>(-1);

/// Describes a change of times that lasts. Times are logarithms.
struct TimeStep {
  std::size_t at = 0;          ///< first result with it
  std::size_t width = 0;       ///< results on either side that show it
  std::string setting;         ///< empty: all settings together
  std::size_t cell = kNoCell;  ///< the only cell of the setting that moved
  std::size_t cells = 1;       ///< of the setting, that were compared
  std::size_t most = 0;        ///< the one of them that moved most
  double change = 0;           ///< new over old level
  double error = 0;            ///< the change is within +- error
};

/// Describes the smallest change of a setting that its results can show.
struct SmallestStep {
  std::string setting;
  std::size_t cells = 0;
  std::size_t results = 0;    ///< that have times of it
  double at_once = kMissing;  ///< by the last result alone; a logarithm, NaN: it cannot
  double best = kMissing;     ///< with most results on either side of it
};

/// Compares, at every result, the last k with the k before, k = 1 … 8, by the rule that `compare`
/// has for two files (docs/history.md, Times). Cost: O(8 r c log c) for r results of c cells.
/// @return the steps by index, and what each setting can show, by name.
std::pair<std::vector<TimeStep>, std::vector<SmallestStep>> find_time_steps(
    const TimeSeries& series, const CompareOptions& rule);

/// Describes a results file of a history, without its rows.
struct CommitResults {
  std::string file;         ///< its path
  std::int64_t index = 0;   ///< where it stands in the order: more is later
  std::string name;         ///< of the commit or release
  std::string source_hash;  ///< git commit of the program
  std::string study;
  std::string created;
  std::size_t environment = 0;  ///< in History::environments
  std::string untimed;          ///< why its times are not judged; empty: they are
  /// Holds how many times as long the short yardsticks took as in the median of the results of its
  /// environment: its times are divided by that. 1 without yardsticks.
  double slowness = 1;
  // What its rows and the tables beside them say:
  std::map<HistoryCell, CellValues> cells;  ///< none in a History, whose lines have them
  std::size_t unfinished = 0;  ///< rows neither ok nor measured: their cells have no values
  double rows_at_a_time = 1;   ///< the largest concurrency
  std::string build_kind;      ///< of a row that has one
  /// Holds medians of the logarithms of the yardsticks near the rows; NaN without any.
  std::array<double, 3> yardsticks{};
  std::map<std::string, std::string> settings;  ///< lasting_settings
  std::vector<GraphFileRecord> graph_files;
};

/// Takes in what one pass over the rows tells; those of batches (strong, weak) are left out. Memory:
/// that of the graphs. Cost: O(r log r) for r rows.
void take_rows(const Rows& rows, CommitResults& into);

/// Describes one measure of one cell over the commits, in one environment.
struct HistoryLine {
  std::size_t environment = 0;
  std::string study;
  HistoryCell cell;
  Measure measure = Measure::time;
  std::vector<std::size_t> results;  ///< in History::results, ascending, one a value
  std::vector<double> values;        ///< as CellValues::means, none missing; times in seconds
  std::vector<std::string> exact;    ///< CellValues::exact, one a value
  std::vector<SideTimes> times;      ///< likewise CellValues::times
  bool is_counted = true;            ///< every one of its results has counts of the cell
  /// Is false for too few results of its setting, and for a time of which all results have counts.
  bool is_judged = true;
};

/// Describes what a commit changed of one measure of one setting, the same way in all cells that it
/// names.
struct HistoryChange {
  std::size_t at = 0;      ///< the first result with it, in History::results
  std::size_t before = 0;  ///< the last one without
  std::string setting;     ///< empty: all settings
  Measure measure = Measure::time;
  int direction = 0;  ///< 1: more of the measure, -1: less, 0: of some graphs more, of others less
  std::size_t cells = 0;     ///< that changed
  std::size_t of = 0;        ///< cells that the setting has there
  double effect = kMissing;  ///< log(after / before), the cells' median; NaN: no ratio
  Interval interval;         ///< of a time: 95 %; else from the least changed cell to the most
  std::size_t line = 0;      ///< of the cell that changed most, in History::lines
};

struct History {
  std::vector<CommitResults> results;                            ///< by index, then name
  std::vector<std::map<std::string, std::string>> environments;  ///< lasting settings
  std::vector<HistoryLine> lines;  ///< by environment, study, cell, measure
  std::vector<HistoryChange>
      changes;  ///< the last commit first, then by measure, the largest first
  /// Tells what times can show, by environment and study.
  std::vector<std::tuple<std::size_t, std::string, SmallestStep>> sights;
};

/// Returns the name that a results file has in a history: PLACE_NAME_STUDY_ENVIRONMENT.h5, where
/// ENVIRONMENT stands for the lasting settings, so that results of two machines do not meet.
/// @param name  letters, digits, '.', '+' and '-'. @throws InputError naming it if it is not.
std::string history_file_name(std::int64_t index, const std::string& name,
                              const StudyIdentity& study,
                              const std::vector<EnvironmentEntry>& environment);

/// Returns the results files (*.h5) of a folder. @param error  why it cannot be listed.
std::vector<std::string> results_files(const std::string& folder, std::error_code& error);

/// Reads every *.h5 of a folder and looks for changes as docs/history.md says. Memory: that of the
/// cells. Cost: reading the files once, and find_time_steps per study and environment.
/// @throws InputError naming the folder if it has none, or the file that is no results file or
/// whose name does not begin with a place and a name.
History read_history(const std::string& folder, const CompareOptions& rule);

/// Returns a text for a terminal: every change under its commit, `most_commits` at most, and what
/// was judged.
std::string summary(const History& history, std::size_t most_commits = 20);

/// Returns everything that the page shows. @param folder  as commands name it.
std::vector<Table> history_tables(const History& history, const std::string& folder);

/// Returns "slower", "fewer instructions", "larger volume", …
const char* direction_text(const HistoryChange& change);

}  // namespace ar3d
