#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "ar3d/analysis/compare/file_times.h"

namespace ar3d {

/// Times of one study in one environment, over its results in their order.
struct TimeSeries {
  struct Result {
    std::array<double, 3> yardsticks{};  ///< logarithms; NaN: unknown
    std::vector<SideTimes> cells;        ///< one for each of `settings`; 0 rounds: not timed
  };
  std::vector<std::string> settings;  ///< which setting each cell is of
  std::vector<Result> results;
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

struct TimeSteps {
  std::vector<TimeStep> steps;         ///< by place
  std::vector<SmallestStep> smallest;  ///< one for each setting, by name
};

/// Compares, at every result, the last k with the k before, k = 1 … 8, by the rule that `compare`
/// has for two files (docs/history.md, Times). Cost: O(8 r c log c) for r results of c cells.
TimeSteps find_time_steps(const TimeSeries& series, const TimeRule& rule);

}  // namespace ar3d
