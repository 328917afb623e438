#include "ar3d/analysis/compare/calibration.h"

#include <algorithm>
#include <cmath>

#include "ar3d/base/random.h"

namespace ar3d {
namespace {

using Ratios = std::vector<std::vector<double>>;

std::size_t alarms(const Ratios& ratios, const TimeRule& rule) {
  const std::vector<TimeVerdict> verdicts = judge_times(ratios, rule);
  return static_cast<std::size_t>(
      std::count_if(verdicts.begin(), verdicts.end(), [](const TimeVerdict& verdict) {
        return verdict.change == TimeChange::slower || verdict.change == TimeChange::faster;
      }));
}

Ratios relabelled(const Ratios& ratios, RandomStream& coins) {
  std::size_t rounds = 0;
  for (const auto& cell : ratios) rounds = std::max(rounds, cell.size());
  std::vector<double> sign(rounds);
  for (double& value : sign) value = coins.below(2) == 0 ? 1 : -1;
  Ratios result = ratios;
  for (auto& cell : result) {
    for (std::size_t i = 0; i < cell.size(); ++i) cell[i] *= sign[i];
  }
  return result;
}

/// The smallest value that at least the share p of the values does not pass; infinities count.
double nearest_rank(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  const auto place = static_cast<std::size_t>(std::ceil(p * static_cast<double>(values.size())));
  return values[std::min(values.size(), std::max<std::size_t>(1, place)) - 1];
}

}  // namespace

double Calibration::false_alarm_rate() const {
  const double judged = static_cast<double>(cells) * static_cast<double>(relabellings);
  return judged > 0 ? static_cast<double>(relabelled_alarms) / judged : 0;
}

Calibration calibrate(const std::vector<std::vector<double>>& log_ratios, const TimeRule& rule,
                      std::size_t relabellings, std::uint64_t seed) {
  Ratios timed = log_ratios;
  std::erase_if(timed, [](const auto& cell) { return cell.empty(); });
  Calibration result;
  result.cells = timed.size();
  result.relabellings = relabellings;
  if (timed.empty()) return result;
  result.pairs = std::min_element(timed.begin(), timed.end(), [](const auto& a, const auto& b) {
                   return a.size() < b.size();
                 })->size();
  result.false_alarms = alarms(timed, rule);
  std::vector<std::vector<double>> slowdowns(timed.size());
  RandomStream coins(seed);
  for (std::size_t i = 0; i < relabellings; ++i) {
    const Ratios again = relabelled(timed, coins);
    result.relabelled_alarms += alarms(again, rule);
    for (std::size_t cell = 0; cell < again.size(); ++cell) {
      slowdowns[cell].push_back(smallest_visible_slowdown(again[cell], rule, again.size()));
    }
  }
  std::vector<double> found;  // in 99 of 100 relabellings
  for (const auto& cell : slowdowns) found.push_back(nearest_rank(cell, 0.99));
  result.smallest_slowdown_median = nearest_rank(found, 0.5);
  result.smallest_slowdown_worst = nearest_rank(found, 1);
  return result;
}

}  // namespace ar3d
