#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ar3d/analysis/statistics.h"

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

/// Holds where an interval is parted, and how much.
struct Split {
  std::size_t at = 0;  ///< first value of the second part
  double height = 0;   ///< |difference of the means| sqrt(ab / (a + b)) for parts of a and b values
};

/// The highest split of all intervals, both parts at least `shortest` long. Cost: their length.
Split largest_split(std::span<const double> values, const SeededIntervals& intervals,
                    std::size_t shortest);

/// Holds where the change of a series with one change may lie, if its noise is normal.
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

/// When a change between commits counts (docs/history.md).
struct ChangeRule {
  std::size_t shortest = 4;        ///< values between two changes, at least
  std::size_t permutations = 999;  ///< none may look as changed as the series: p <= 1 / 1000
  double threshold = 0.02;         ///< smaller changes do not matter: 0.02 is 2 %
  double confidence = 0.95;        ///< of the interval of an effect
  std::uint64_t seed = 1;          ///< of the permutations: equal seeds give equal results
};

/// One place where the level of a series changes.
struct ChangePoint {
  std::size_t at = 0;     ///< the first value of the new level
  std::size_t first = 0;  ///< with 95 % confidence `at` is one of first … last
  std::size_t last = 0;
  double effect = 0;  ///< log(after / before), up to the neighbouring changes
  Interval interval;  ///< of the effect
  /// A straight line fits what is between the neighbouring changes better than one step does: the
  /// change came little by little, and `at` is about its middle.
  bool gradual = false;
};

/// Changes of the level of a noisy series: Steps H.2 to H.6 of docs/history.md. If the values
/// are exchangeable (no change, and noise that does not depend on the commits before), a change is
/// found with probability at most 1 / (permutations + 1), whatever the distribution of the noise.
/// @param log_values  finite, in the order of the commits.
/// Cost: O(permutations k log k) for k values where there is a change, O(k log k) where none is.
std::vector<ChangePoint> find_changes(std::span<const double> log_values, const ChangeRule& rule);

/// Changes of a series without noise: a value that differs by more than `threshold` (of logarithms)
/// from the one at the last change, or from the first one. Its interval is the effect itself. Where
/// smaller differences have added up, the change is gradual and lies anywhere since the last one.
std::vector<ChangePoint> find_exact_changes(std::span<const double> log_values, double threshold);

/// Hodges and Lehmann's estimate of the shift from `before` to `after`, the median of all
/// differences, and its interval from the distribution of Mann and Whitney's statistic in the
/// normal approximation. @param before, after  not empty. Cost: O(ab log ab).
struct Shift {
  double estimate = 0;
  Interval interval;
};
Shift shift_between(std::span<const double> before, std::span<const double> after,
                    double confidence);

}  // namespace ar3d
