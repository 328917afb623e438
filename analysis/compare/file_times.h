#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "ar3d/analysis/compare/pairing.h"
#include "ar3d/analysis/compare/time_change.h"

namespace ar3d {

/// Drawing times of one cell in two files that were measured one after the other, over the rounds
/// (repetitions) that both have; all as natural logarithms. Where all rows have yardsticks, a time
/// is in units of the short ones near it.
struct CellTimes {
  std::string setting;     ///< algorithm_label()
  std::size_t rounds = 0;  ///< of the graph that has the fewest; 0: it is not timed
  double ratio = 0;        ///< log(new / base) of the medians over the rounds, mean over the graphs
  double spread = 0;       ///< standard error of `ratio`, from the rounds as if independent
  /// Holds log(median of the first half of the rounds / median of the second) of base and new.
  std::array<double, 2> halves{};
  std::size_t graphs = 1;
};
CellTimes cell_times(const PairedCell& cell);

/// All cells of one algorithm with its options.
struct SettingTimes {
  std::string name;
  std::size_t cells = 0;
  double ratio = 0;     ///< log(new / base), median over the cells
  double distance = 0;  ///< of `ratio` from the common factor
  double error = 0;     ///< the distance is within +- error
  TimeChange change = TimeChange::undecided;
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
  std::vector<TimeChange> cells;       ///< one for each cell
};

inline constexpr std::size_t kFewestRounds = 4;

/// @param cells  of one setting each. @param base, now  for the yardsticks of their rows. Cost: O(c
/// log c) for c cells.
FileTimes judge_file_times(const std::vector<CellTimes>& cells, const Results& base,
                           const Results& now, const TimeRule& rule);

/// "diamond +19.8 % [+18.9 %, +20.7 %]": the distance of a setting.
std::string distance_text(const SettingTimes& setting);

/// Returns what a person is told: how fast the machine was, what moved against all others.
std::string times_sentence(const FileTimes& times);

}  // namespace ar3d
