#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ar3d/analysis/statistics.h"

namespace ar3d {

/// The null distribution of Wilcoxon's signed-rank statistic W of k pairs: the sum of the ranks of
/// the positive differences when every sign is a fair coin. Exact up to kExactPairs, beyond that
/// the normal approximation with continuity correction.
class SignedRankDistribution {
 public:
  static constexpr std::size_t kExactPairs = 100;
  /// Cost: O(k^3) up to kExactPairs, else O(1).
  explicit SignedRankDistribution(std::size_t pairs);
  std::size_t pairs() const { return pairs_; }
  /// P(W <= w) = P(W >= k(k+1)/2 - w).
  double tail(std::size_t w) const;
  /// The largest w with tail(w) <= p; none if even W = 0 is likelier than p.
  std::optional<std::size_t> critical(double p) const;

 private:
  std::size_t pairs_;
  std::vector<double> cumulative_;  ///< of W = 0, 1, …; empty beyond kExactPairs
};

/// The means (d_i + d_j) / 2 of all i <= j, sorted. The statistic W is how many of them are
/// positive; their median is the Hodges-Lehmann estimate. Cost: O(k^2 log k) for k differences.
std::vector<double> walsh_averages(std::span<const double> differences);

/// Says whether paired differences are centred at 0, by Wilcoxon's signed-rank test. It holds for
/// every distribution of the noise, however heavy its tails, as long as a difference and its
/// negative are equally likely, which is so if the two measurements of a pair are interchangeable.
struct SignedRankTest {
  std::size_t pairs = 0;
  double estimate = 0;     ///< Hodges and Lehmann's; NaN without pairs
  Interval interval{};     ///< for the centre; NaN ends where pairs are too few for the confidence
  double p_greater = 1;    ///< against "centred at 0 or below"
  double p_less = 1;       ///< against "centred at 0 or above"
  double p_value() const;  ///< two-sided
};

/// Ties and zeros count against the alternative, which keeps the p-values valid: breaking the ties
/// at random would make a continuous symmetric sample with at least that W.
/// @param differences  finite. @param confidence  of the interval, in (0, 1).
SignedRankTest signed_rank_test(std::span<const double> differences,
                                const SignedRankDistribution& distribution, double confidence);

/// Benjamini and Hochberg's adjusted p-values: rejecting where the adjusted one is at most q keeps
/// the expected share of false ones among the rejected at q or below. Cost: O(m log m).
std::vector<double> adjusted_p_values(std::span<const double> p_values);

}  // namespace ar3d
