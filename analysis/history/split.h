#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace ar3d {

/// The values, those further than three standard deviations from their median moved to there; the
/// standard deviation is estimated from the differences of neighbours, which a change of the level
/// does not disturb (1.4826 times their median absolute value, divided by sqrt 2). Nothing is moved
/// if more than half of the neighbours are equal.
std::vector<double> winsorised(std::span<const double> values);

/// The same, with those before `at` around the median of these, and the others around that of the
/// others: what two levels leave of the values.
std::vector<double> winsorised(std::span<const double> values, std::size_t at);

/// [begin, end) of each.
using SeededIntervals = std::vector<std::pair<std::size_t, std::size_t>>;

/// The intervals of seeded binary segmentation with decay 1 / sqrt 2 (Kovács, Bühlmann, Li and Munk
/// 2023): all of [0, size), then ever shorter ones that overlap, down to `shortest`. A change that
/// another one follows has an interval without the other. In all O(size log size) long.
SeededIntervals seeded_intervals(std::size_t size, std::size_t shortest);

/// Where an interval is parted, and how much.
struct Split {
  std::size_t at = 0;  ///< first value of the second part
  double height = 0;   ///< |difference of the means| sqrt(ab / (a + b)) for parts of a and b values
};

/// The highest split of all intervals, both parts at least `shortest` long. Cost: their length.
Split largest_split(std::span<const double> values, const SeededIntervals& intervals,
                    std::size_t shortest);

/// Where the change of a series with one change may lie, if its noise is normal.
struct PlausibleSplits {
  std::size_t first = 0;
  std::size_t last = 0;
  /// The squares of the residuals of a straight line have a smaller sum than those of two levels.
  bool line_fits_better = false;
};

/// All splits whose sum of squared residuals is larger than that of `at` by less than
/// kPlausible times the variance of the residuals. Cost: linear.
PlausibleSplits plausible_splits(std::span<const double> values, std::size_t at);

/// Chosen so that the true place is among them 95 times of 100 (change_points_long_test.cpp).
inline constexpr double kPlausible = 8;

}  // namespace ar3d
