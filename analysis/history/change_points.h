#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/analysis/statistics.h"

namespace ar3d {

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
