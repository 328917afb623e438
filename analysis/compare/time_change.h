#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "ar3d/analysis/statistics.h"

namespace ar3d {

/// Represents the null distribution of Wilcoxon's signed-rank statistic W of k pairs: the sum of
/// the ranks of the positive differences when every sign is a fair coin. Exact up to kExactPairs,
/// beyond that the normal approximation with continuity correction.
class SignedRankDistribution {
 public:
  static constexpr std::size_t kExactPairs = 100;
  /// Makes the distribution. Cost: O(k^3) up to kExactPairs, else O(1).
  explicit SignedRankDistribution(std::size_t pairs);
  std::size_t pairs() const { return pairs_; }
  /// Returns P(W <= w) = P(W >= k(k+1)/2 - w).
  double tail(std::size_t w) const;
  /// Returns the largest w with tail(w) <= p; none if even W = 0 is likelier than p.
  std::optional<std::size_t> critical(double p) const;

 private:
  std::size_t pairs_;
  std::vector<double> cumulative_;  ///< of W = 0, 1, …; empty beyond kExactPairs
};

/// Returns the means (d_i + d_j) / 2 of all i <= j, sorted. The statistic W is how many of them are
/// positive; their median is the Hodges-Lehmann estimate. Cost: O(k^2 log k) for k differences.
std::vector<double> walsh_averages(std::span<const double> differences);

/// Returns Benjamini and Hochberg's adjusted p-values: rejecting where the adjusted one is at most
/// q keeps the expected share of false ones among the rejected at q or below. Cost: O(m log m).
std::vector<double> adjusted_p_values(std::span<const double> p_values);

/// Tells when a change counts, and what is judged.
struct CompareOptions {
  double threshold = 0.05;              ///< smaller changes of time do not matter: 0.05 is 5 %
  double significance = 0.001;          ///< largest two-sided p-value of one cell
  double false_discovery_rate = 0.002;  ///< largest adjusted p-value over all cells
  double confidence = 0.95;             ///< of the interval of a cell's ratio
  double instruction_threshold = 0.01;  ///< smaller changes of counted instructions do not matter
  double cycle_threshold = 0.05;        ///< of estimated cycles, which feel where data lie
  bool time_always = false;             ///< judge times of unlike environments too
  bool drawings_only = false;           ///< judge what has no noise, and no times
};

/// Sorts by what outweighs what. unjudged: nothing got worse among what has no noise, and the
/// times were not judged. Of times pass: the interval of the ratio lies within the threshold on both
/// sides; improved, regressed: faster or slower, significantly, and the estimate passes the
/// threshold; inconclusive: neither, for too few pairs, too much noise, or right at the threshold.
enum class Verdict { pass, improved, unjudged, inconclusive, regressed, violated };
/// Returns "PASS", "IMPROVED", "UNJUDGED", "INCONCLUSIVE", "REGRESSED", "VIOLATED"
const char* to_string(Verdict verdict);

/// Says whether paired differences, of log(new time / base time), are centred at 0, by Wilcoxon's
/// signed-rank test. It holds for every distribution of the noise, however heavy its tails, as long
/// as a difference and its negative are equally likely, which is so if the two measurements of a
/// pair are interchangeable.
struct TimeVerdict {
  std::size_t pairs = 0;   ///< 0: nothing was timed
  double estimate = 0;     ///< Hodges and Lehmann's; NaN without pairs
  Interval interval{};     ///< for the centre; NaN ends where pairs are too few for the confidence
  double p_greater = 1;    ///< against "centred at 0 or below"
  double p_less = 1;       ///< against "centred at 0 or above"
  double p_value() const;  ///< two-sided; NaN where nothing was tested
  double adjusted_p = 1;
  /// Holds log(1 + smallest change that is found with this noise), where the comparison says so.
  double visible = std::numeric_limits<double>::infinity();
  Verdict change = Verdict::inconclusive;
  bool follows_setting = false;  ///< its own pairs leave it open
};

/// Tests whether the differences are centred at 0. Ties and zeros count against the alternative,
/// which keeps the p-values valid: breaking the ties at random would make a continuous symmetric
/// sample with at least that W.
/// @param differences  finite.
/// @param confidence  of the interval, in (0, 1).
TimeVerdict signed_rank_test(std::span<const double> differences,
                             const SignedRankDistribution& distribution, double confidence);

/// Returns the fewest pairs with which one cell among `cells` can be found (Benjamini and
/// Hochberg's threshold): all of them point one way.
std::size_t fewest_pairs(const CompareOptions& rule, std::size_t cells = 1);

/// Returns one verdict a cell. @param log_ratios  log(new / base) of the pairs of every cell,
/// finite. A cell with more than 2000 pairs is thinned evenly to at most that many.
std::vector<TimeVerdict> judge_times(const std::vector<std::vector<double>>& log_ratios,
                                     const CompareOptions& rule);

/// Returns the smallest true slowdown with which `log_ratios`, measured without any, would be
/// judged slower while all other cells of `cells` stay as they are: ratio - 1; infinite if there
/// are too few pairs.
double smallest_visible_slowdown(std::vector<double> log_ratios, const CompareOptions& rule,
                                 std::size_t cells);

}  // namespace ar3d
