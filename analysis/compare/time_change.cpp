#include "ar3d/analysis/compare/time_change.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

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

std::size_t pairs_for(double p_value) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(1 - std::log2(p_value) - 1e-9)));
}

/// The p-value that one cell needs when no other cell is significant.
double needed_p(const TimeRule& rule, std::size_t cells) {
  const auto m = static_cast<double>(std::max<std::size_t>(1, cells));
  return std::min(rule.significance, rule.false_discovery_rate / m);
}

TimeChange change_of(const TimeVerdict& verdict, const TimeRule& rule) {
  const double limit = std::log1p(rule.threshold);
  const SignedRankTest& test = verdict.test;
  const bool significant =
      test.p_value() <= rule.significance && verdict.adjusted_p <= rule.false_discovery_rate;
  if (significant && test.estimate >= limit) return TimeChange::slower;
  if (significant && test.estimate <= -limit) return TimeChange::faster;
  // NaN ends, where pairs are too few, compare false.
  const bool inside = test.interval.low > -limit && test.interval.high < limit;
  return inside ? TimeChange::same : TimeChange::undecided;
}

}  // namespace

std::size_t fewest_pairs(const TimeRule& rule) { return pairs_for(rule.significance); }

std::size_t fewest_pairs(const TimeRule& rule, std::size_t cells) {
  return pairs_for(needed_p(rule, cells));
}

std::vector<TimeVerdict> judge_times(const std::vector<std::vector<double>>& log_ratios,
                                     const TimeRule& rule) {
  std::map<std::size_t, SignedRankDistribution> distributions;
  std::vector<TimeVerdict> verdicts(log_ratios.size());
  std::vector<double> p_values;
  std::vector<std::size_t> timed;
  for (std::size_t cell = 0; cell < log_ratios.size(); ++cell) {
    const std::vector<double> values = thinned(log_ratios[cell]);
    const auto distribution = distributions.try_emplace(values.size(), values.size()).first;
    verdicts[cell].test = signed_rank_test(values, distribution->second, rule.confidence);
    if (values.empty()) continue;
    timed.push_back(cell);
    p_values.push_back(verdicts[cell].test.p_value());
  }
  const std::vector<double> adjusted = adjusted_p_values(p_values);
  for (std::size_t i = 0; i < timed.size(); ++i) verdicts[timed[i]].adjusted_p = adjusted[i];
  for (TimeVerdict& verdict : verdicts) verdict.change = change_of(verdict, rule);
  return verdicts;
}

double smallest_visible_slowdown(std::vector<double> log_ratios, const TimeRule& rule,
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

}  // namespace ar3d
