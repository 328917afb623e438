// The steps in brackets are those of docs/history.md.
#include "ar3d/analysis/history/change_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ar3d/analysis/history/split.h"
#include "ar3d/base/random.h"

namespace ar3d {
namespace {

struct Part {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - begin; }
};

/// Whether a permutation of the values looks at least as changed as the values do (Step H.3).
bool is_reached_by_chance(const std::vector<double>& values, const Split& found,
                          const SeededIntervals& intervals, const Part& part,
                          const ChangeRule& rule) {
  constexpr double kTie = 1 - 1e-9;  // sums of the same numbers in another order
  RandomStream random(rule.seed, mix_seed(part.begin, part.end));
  std::vector<double> permuted = values;
  for (std::size_t i = 0; i < rule.permutations; ++i) {
    random.shuffle(std::span(permuted));
    if (largest_split(permuted, intervals, rule.shortest).height >= kTie * found.height)
      return true;
  }
  return false;
}

/// The changes within one part, halved where one is found (Step H.4), unsorted.
void find_in(std::span<const double> values, const Part& part, const ChangeRule& rule,
             std::vector<std::size_t>& into) {
  if (part.size() < 2 * rule.shortest) return;
  const std::vector<double> clipped = winsorised(values.subspan(part.begin, part.size()));
  const SeededIntervals intervals = seeded_intervals(part.size(), 2 * rule.shortest);
  const Split split = largest_split(clipped, intervals, rule.shortest);
  if (!(split.height > 0) || is_reached_by_chance(clipped, split, intervals, part, rule)) return;
  const std::size_t at = part.begin + split.at;
  into.push_back(at);
  find_in(values, {part.begin, at}, rule, into);
  find_in(values, {at, part.end}, rule, into);
}

/// The changes before and behind the i-th, or the ends of the series.
Part between_neighbours(const std::vector<std::size_t>& at, std::size_t i, std::size_t size) {
  return {i == 0 ? 0 : at[i - 1], i + 1 == at.size() ? size : at[i + 1]};
}

/// Moves every change to the best place between its neighbours (Step H.5).
void settle(std::span<const double> values, std::size_t shortest, std::vector<std::size_t>& at) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Part part = between_neighbours(at, i, values.size());
    if (part.size() < 2 * shortest) continue;
    const std::vector<double> clipped = winsorised(values.subspan(part.begin, part.size()));
    at[i] = part.begin + largest_split(clipped, {{0, part.size()}}, shortest).at;
  }
}

ChangePoint describe(std::span<const double> values, const std::vector<std::size_t>& at,
                     std::size_t i, double confidence) {
  const Part part = between_neighbours(at, i, values.size());
  const auto before = values.subspan(part.begin, at[i] - part.begin);
  const auto after = values.subspan(at[i], part.end - at[i]);
  const Shift shift = shift_between(before, after, confidence);
  const std::vector<double> clipped =
      winsorised(values.subspan(part.begin, part.size()), at[i] - part.begin);
  const PlausibleSplits places = plausible_splits(clipped, at[i] - part.begin);
  // A burst at the commit beside the change can move it by one.
  const std::size_t first = std::min(places.first, at[i] - part.begin - 1);
  const std::size_t last = std::max(places.last, at[i] - part.begin + 1);
  return {.at = at[i],
          .first = part.begin + std::max<std::size_t>(first, 1),
          .last = part.begin + std::min(last, part.size() - 1),
          .effect = shift.estimate,
          .interval = shift.interval,
          .gradual = places.line_fits_better};
}

/// Gives up the smallest change below the threshold, then the next (Step H.6).
/// @return false if none is.
bool drop_smallest(std::vector<std::size_t>& at, const std::vector<ChangePoint>& changes,
                   double threshold) {
  if (changes.empty()) return false;
  const auto smallest = std::min_element(
      changes.begin(), changes.end(),
      [](const auto& a, const auto& b) { return std::abs(a.effect) < std::abs(b.effect); });
  if (std::abs(smallest->effect) >= std::log1p(threshold)) return false;
  at.erase(at.begin() + (smallest - changes.begin()));
  return true;
}

}  // namespace

std::vector<ChangePoint> find_changes(std::span<const double> log_values, const ChangeRule& rule) {
  std::vector<std::size_t> at;
  find_in(log_values, {0, log_values.size()}, rule, at);
  std::sort(at.begin(), at.end());
  settle(log_values, rule.shortest, at);
  std::vector<ChangePoint> changes;
  do {
    changes.clear();
    for (std::size_t i = 0; i < at.size(); ++i) {
      changes.push_back(describe(log_values, at, i, rule.confidence));
    }
  } while (drop_smallest(at, changes, rule.threshold));
  return changes;
}

std::vector<ChangePoint> find_exact_changes(std::span<const double> log_values, double threshold) {
  std::vector<ChangePoint> changes;
  std::size_t last_change = 0;
  for (std::size_t i = 1; i < log_values.size(); ++i) {
    const double effect = log_values[i] - log_values[last_change];
    if (std::abs(effect) <= threshold) continue;
    const bool at_once = std::abs(log_values[i] - log_values[i - 1]) > threshold;
    changes.push_back({.at = i,
                       .first = at_once ? i : last_change + 1,
                       .last = i,
                       .effect = effect,
                       .interval = {effect, effect},
                       .gradual = !at_once});
    last_change = i;
  }
  return changes;
}

Shift shift_between(std::span<const double> before, std::span<const double> after,
                    double confidence) {
  std::vector<double> differences;
  differences.reserve(before.size() * after.size());
  for (const double b : before) {
    for (const double a : after) differences.push_back(a - b);
  }
  std::sort(differences.begin(), differences.end());
  const auto pairs = static_cast<double>(differences.size());
  const auto values = static_cast<double>(before.size() + after.size());
  const double z =
      student_t_quantile((1 + confidence) / 2, std::numeric_limits<double>::infinity());
  const double rank = std::floor(pairs / 2 - z * std::sqrt(pairs * (values + 1) / 12));
  const auto outside = static_cast<std::size_t>(std::max(rank, 1.0)) - 1;
  const std::size_t middle = differences.size() / 2;
  const bool odd = differences.size() % 2 == 1;
  return {odd ? differences[middle] : (differences[middle - 1] + differences[middle]) / 2,
          {differences[outside], differences[differences.size() - 1 - outside]}};
}

}  // namespace ar3d
