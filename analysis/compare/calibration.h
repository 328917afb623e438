#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/analysis/compare/time_change.h"

namespace ar3d {

/// What a comparison of a program with itself tells about the machine.
struct Calibration {
  std::size_t cells = 0;         ///< with at least one pair
  std::size_t pairs = 0;         ///< of the cell with the fewest
  std::size_t false_alarms = 0;  ///< cells judged slower or faster, though nothing differs
  std::size_t relabellings = 0;
  std::size_t relabelled_alarms = 0;    ///< cells judged so over all relabellings
  double smallest_slowdown_median = 0;  ///< smallest slowdown that would be found in 99 of 100
  double smallest_slowdown_worst = 0;   ///< relabellings: median over cells, and the worst cell

  /// False alarms a cell and comparison, from the relabellings.
  double false_alarm_rate() const;
};

/// Judges the pairs of a comparison of a program with itself. In such a comparison every pair may
/// have its two sides exchanged; each relabelling exchanges the sides of every round (the i-th pair
/// of all cells) by a fair coin, keeping what the cells of a round have in common, and judges
/// again.
/// @param log_ratios  as judge_times. @param seed  of the coins: equal seeds give equal results.
Calibration calibrate(const std::vector<std::vector<double>>& log_ratios, const TimeRule& rule,
                      std::size_t relabellings = 1000, std::uint64_t seed = 1);

}  // namespace ar3d
