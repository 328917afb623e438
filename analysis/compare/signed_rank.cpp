// Wilcoxon's signed-rank test, because it needs no assumption about the tails of the noise. The
// distribution is exact for few pairs; for many it is the normal approximation.
#include "ar3d/analysis/compare/signed_rank.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::size_t largest_sum(std::size_t pairs) { return pairs * (pairs + 1) / 2; }

/// P(W <= w) for w = 0 … k(k+1)/2: every rank is in the sum or not, with probability 1/2 each.
std::vector<double> cumulative_of(std::size_t pairs) {
  std::vector<double> probability(largest_sum(pairs) + 1, 0);
  probability[0] = 1;
  for (std::size_t rank = 1; rank <= pairs; ++rank) {
    for (std::size_t sum = largest_sum(rank) + 1; sum-- > 0;) {
      const double without = probability[sum];
      const double with = sum >= rank ? probability[sum - rank] : 0;
      probability[sum] = (without + with) / 2;
    }
  }
  std::partial_sum(probability.begin(), probability.end(), probability.begin());
  return probability;
}

}  // namespace

SignedRankDistribution::SignedRankDistribution(std::size_t pairs) : pairs_(pairs) {
  if (pairs <= kExactPairs) cumulative_ = cumulative_of(pairs);
}

double SignedRankDistribution::tail(std::size_t w) const {
  if (w >= largest_sum(pairs_)) return 1;
  if (!cumulative_.empty()) return cumulative_[w];
  const auto k = static_cast<double>(pairs_);
  const boost::math::normal normal(k * (k + 1) / 4, std::sqrt(k * (k + 1) * (2 * k + 1) / 24));
  return boost::math::cdf(normal, static_cast<double>(w) + 0.5);
}

std::optional<std::size_t> SignedRankDistribution::critical(double p) const {
  if (tail(0) > p) return std::nullopt;
  std::size_t low = 0, high = largest_sum(pairs_);  // tail(low) <= p, and the answer is <= high
  while (low < high) {
    const std::size_t middle = high - (high - low) / 2;
    if (tail(middle) <= p) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return low;
}

std::vector<double> walsh_averages(std::span<const double> differences) {
  std::vector<double> averages;
  averages.reserve(largest_sum(differences.size()));
  for (std::size_t i = 0; i < differences.size(); ++i) {
    for (std::size_t j = i; j < differences.size(); ++j) {
      averages.push_back((differences[i] + differences[j]) / 2);
    }
  }
  std::sort(averages.begin(), averages.end());
  return averages;
}

double SignedRankTest::p_value() const { return std::min(1.0, 2 * std::min(p_greater, p_less)); }

SignedRankTest signed_rank_test(std::span<const double> differences,
                                const SignedRankDistribution& distribution, double confidence) {
  expect(differences.size() == distribution.pairs(), "a signed-rank test of other pairs");
  SignedRankTest test;
  test.pairs = differences.size();
  test.estimate = kNone;
  test.interval = {kNone, kNone};
  if (differences.empty()) return test;
  const std::vector<double> averages = walsh_averages(differences);
  const auto [zeros_begin, zeros_end] = std::equal_range(averages.begin(), averages.end(), 0.0);
  // W >= positive is as likely as W <= all - positive.
  test.p_greater = distribution.tail(static_cast<std::size_t>(zeros_end - averages.begin()));
  test.p_less = distribution.tail(static_cast<std::size_t>(averages.end() - zeros_begin));
  const std::size_t all = averages.size();
  test.estimate = (averages[(all - 1) / 2] + averages[all / 2]) / 2;
  if (const auto cut = distribution.critical((1 - confidence) / 2)) {
    test.interval = {averages[*cut], averages[all - 1 - *cut]};
  }
  return test;
}

std::vector<double> adjusted_p_values(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] > p_values[b]; });
  std::vector<double> adjusted(p_values.size());
  double smallest = 1;
  for (std::size_t i = 0; i < order.size(); ++i) {  // from the largest down
    const auto rank = static_cast<double>(order.size() - i);
    smallest = std::min(smallest, p_values[order[i]] * static_cast<double>(order.size()) / rank);
    adjusted[order[i]] = smallest;
  }
  return adjusted;
}

}  // namespace ar3d
