#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/analysis/compare/pairing.h"
#include "ar3d/analysis/compare/time_change.h"

namespace ar3d {

/// Describes drawing times of one cell in one file; all as natural logarithms, in units of the
/// short yardsticks near each where there are any.
struct SideTimes {
  std::size_t rounds = 0;  ///< of the graph that has the fewest; 0: it is not timed
  std::size_t graphs = 0;
  double level = 0;     ///< median over the rounds, mean over the graphs
  double variance = 0;  ///< squared standard error of `level`, from the rounds as if independent
  double halves = 0;    ///< as `level`: first half of the rounds over the second
};
/// Holds a graph's times, each with its round, by its requested n, index and seed.
using GraphRounds = std::map<std::tuple<std::int64_t, std::int64_t, std::uint64_t>,
                             std::vector<std::pair<std::int64_t, double>>>;
SideTimes side_times(const GraphRounds& graphs);

/// Is the same in two files that were measured one after the other, over the rounds that both have.
struct CellTimes {
  std::string setting;             ///< algorithm_label()
  std::size_t rounds = 0;          ///< as SideTimes::rounds, the fewer
  double ratio = 0;                ///< log(new / base)
  double spread = 0;               ///< standard error of `ratio`
  std::array<double, 2> halves{};  ///< of base and new
  std::size_t graphs = 1;
};
CellTimes cell_times(const PairedCell& cell);
CellTimes cell_times(std::string setting, const SideTimes& base, const SideTimes& now);

/// Describes all cells of one algorithm with its options.
struct SettingTimes {
  std::string name;
  std::size_t cells = 0;
  double ratio = 0;     ///< log(new / base), median over the cells
  double distance = 0;  ///< of `ratio` from the common factor
  double error = 0;     ///< the distance is within +- error
  double least = 0;     ///< distance from which on it has changed
  Verdict change = Verdict::inconclusive;
};

/// Holds what times of two files say, step by step as docs/analysis.md does.
struct FileTimes {
  std::array<std::string, 2> rounds;   ///< kTimingRounds of base and new; empty: unknown
  std::array<double, 3> yardsticks{};  ///< log(new / base) of kYardsticks; NaN: not in both files
  double machine = 0;                  ///< mean of the short yardsticks; 0 if unknown
  double common = 0;                   ///< log of the factor by which all settings moved together
  double residual = 0;                 ///< robust standard deviation of cells about their setting
  bool is_known = true;                ///< the yardsticks account for how fast the machine was
  std::vector<SettingTimes> settings;  ///< those with a time, in the order of the cells
  std::vector<Verdict> cells;          ///< one for each cell
  std::vector<double> errors;  ///< of each cell: its ratio is within +- error; NaN: not timed
};

inline constexpr std::size_t kFewestRounds = 4;

/// Holds settings that tell a common factor.
inline constexpr std::size_t kFewestSettings = 3;
/// Tells what yardsticks alone may be wrong by, where fewer settings are there.
inline constexpr double kWithoutOthers = 0.05;

/// Judges every cell and setting.
/// @param cells  of one setting each.
/// @param yardsticks  as FileTimes. Cost: O(c log c) for c cells.
FileTimes judge_file_times(const std::vector<CellTimes>& cells,
                           const std::array<double, 3>& yardsticks, const CompareOptions& rule);

/// Returns medians of the logarithms of the yardsticks of all rows; NaN: there are none.
std::array<double, 3> yardsticks_of(const Results& results);

/// Returns the sentence that says how fast the machine was.
std::string times_sentence(const FileTimes& times);

}  // namespace ar3d
