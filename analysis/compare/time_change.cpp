// When a change of time counts.
#include "ar3d/analysis/compare/time_change.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "ar3d/base/error.h"

namespace ar3d {

namespace {

constexpr std::size_t kMostPairs = 2000;  // two million Walsh averages

std::vector<double> thinned(const std::vector<double>& values) {
  const std::size_t step = (values.size() + kMostPairs - 1) / kMostPairs;
  if (step <= 1) return values;
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); i += step) kept.push_back(values[i]);
  return kept;
}

/// The p-value that one cell needs when no other cell is significant.
double needed_p(const CompareOptions& rule, std::size_t cells) {
  const auto m = static_cast<double>(std::max<std::size_t>(1, cells));
  return std::min(rule.significance, rule.false_discovery_rate / m);
}

Verdict change_of(const TimeVerdict& verdict, const CompareOptions& rule) {
  const double limit = std::log1p(rule.threshold);
  const bool significant =
      verdict.p_value() <= rule.significance && verdict.adjusted_p <= rule.false_discovery_rate;
  if (significant && verdict.estimate >= limit) return Verdict::regressed;
  if (significant && verdict.estimate <= -limit) return Verdict::improved;
  // NaN ends, where pairs are too few, compare false.
  const bool inside = verdict.interval.low > -limit && verdict.interval.high < limit;
  return inside ? Verdict::pass : Verdict::inconclusive;
}

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

std::size_t fewest_pairs(const CompareOptions& rule, std::size_t cells) {
  const double pairs = std::ceil(1 - std::log2(needed_p(rule, cells)) - 1e-9);
  return static_cast<std::size_t>(std::max(1.0, pairs));
}

std::vector<TimeVerdict> judge_times(const std::vector<std::vector<double>>& log_ratios,
                                     const CompareOptions& rule) {
  std::map<std::size_t, SignedRankDistribution> distributions;
  std::vector<TimeVerdict> verdicts(log_ratios.size());
  std::vector<double> p_values;
  std::vector<std::size_t> timed;
  for (std::size_t cell = 0; cell < log_ratios.size(); ++cell) {
    const std::vector<double> values = thinned(log_ratios[cell]);
    const auto distribution = distributions.try_emplace(values.size(), values.size()).first;
    verdicts[cell] = signed_rank_test(values, distribution->second, rule.confidence);
    if (values.empty()) continue;
    timed.push_back(cell);
    p_values.push_back(verdicts[cell].p_value());
  }
  const std::vector<double> adjusted = adjusted_p_values(p_values);
  for (std::size_t i = 0; i < timed.size(); ++i) verdicts[timed[i]].adjusted_p = adjusted[i];
  for (TimeVerdict& verdict : verdicts) verdict.change = change_of(verdict, rule);
  return verdicts;
}

double smallest_visible_slowdown(std::vector<double> log_ratios, const CompareOptions& rule,
                                 std::size_t cells) {
  log_ratios = thinned(log_ratios);
  const SignedRankDistribution distribution(log_ratios.size());
  const auto critical = distribution.critical(needed_p(rule, cells) / 2);
  if (!critical || log_ratios.empty()) return std::numeric_limits<double>::infinity();
  // At most `critical` Walsh averages may stay at or below 0, and their median must pass the limit.
  const std::vector<double> averages = walsh_averages(log_ratios);
  const double estimate = (averages[(averages.size() - 1) / 2] + averages[averages.size() / 2]) / 2;
  return std::expm1(std::max(-averages[*critical], std::log1p(rule.threshold) - estimate));
}

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

double TimeVerdict::p_value() const { return std::min(2 * std::min(p_greater, p_less), 1.0); }

TimeVerdict signed_rank_test(std::span<const double> differences,
                             const SignedRankDistribution& distribution, double confidence) {
  expect(differences.size() == distribution.pairs(), "a signed-rank test of other pairs");
  TimeVerdict test;
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
