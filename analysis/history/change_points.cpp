// Changes of the level of a series: seeded intervals, permutation test, place and effect. The steps
// in brackets are those of docs/history.md.
#include "ar3d/analysis/history/change_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ar3d/analysis/statistics.h"
#include "ar3d/base/random.h"

namespace ar3d {

namespace {

constexpr double kClip = 3;            // standard deviations
constexpr double kNormalMad = 1.4826;  // standard deviation / median absolute deviation

/// sums[i] is the sum of the first i values.
std::vector<double> partial_sums(std::span<const double> values) {
  std::vector<double> sums(values.size() + 1, 0);
  for (std::size_t i = 0; i < values.size(); ++i) sums[i + 1] = sums[i] + values[i];
  return sums;
}

/// Of the noise, from the differences of neighbours.
double deviation_of(std::span<const double> values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    steps.push_back(std::abs(values[i] - values[i - 1]));
  }
  return kNormalMad * median(std::move(steps)) / std::numbers::sqrt2;
}

void clip(std::span<double> values, double deviation) {
  if (!(deviation > 0)) return;
  const double centre = median({values.begin(), values.end()}), reach = kClip * deviation;
  for (double& value : values) value = std::clamp(value, centre - reach, centre + reach);
}

double square(double x) { return x * x; }

/// Sum of squares of the residuals of the least-squares line through (i, values[i]).
double residuals_of_line(std::span<const double> values) {
  const auto count = static_cast<double>(values.size());
  const double mean_x = (count - 1) / 2, mean_y = mean(values);
  double xy = 0, yy = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    xy += (static_cast<double>(i) - mean_x) * (values[i] - mean_y);
    yy += square(values[i] - mean_y);
  }
  const double xx = count * (count * count - 1) / 12;
  return yy - xy * xy / xx;
}

struct Stretch {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - begin; }
};

/// Whether a permutation of the values looks at least as changed as the values do (Step H.3).
bool is_reached_by_chance(const std::vector<double>& values, const Split& found,
                          const SeededIntervals& intervals, const Stretch& part,
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
void find_in(std::span<const double> values, const Stretch& part, const ChangeRule& rule,
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
Stretch between_neighbours(const std::vector<std::size_t>& at, std::size_t i, std::size_t size) {
  return {i == 0 ? 0 : at[i - 1], i + 1 == at.size() ? size : at[i + 1]};
}

/// Moves every change to the best place between its neighbours (Step H.5).
void settle(std::span<const double> values, std::size_t shortest, std::vector<std::size_t>& at) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Stretch part = between_neighbours(at, i, values.size());
    if (part.size() < 2 * shortest) continue;
    const std::vector<double> clipped = winsorised(values.subspan(part.begin, part.size()));
    at[i] = part.begin + largest_split(clipped, {{0, part.size()}}, shortest).at;
  }
}

ChangePoint describe(std::span<const double> values, const std::vector<std::size_t>& at,
                     std::size_t i, double confidence) {
  const Stretch part = between_neighbours(at, i, values.size());
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

std::vector<double> winsorised(std::span<const double> values) {
  std::vector<double> clipped(values.begin(), values.end());
  clip(clipped, deviation_of(values));
  return clipped;
}

std::vector<double> winsorised(std::span<const double> values, std::size_t at) {
  std::vector<double> clipped(values.begin(), values.end());
  const double deviation = deviation_of(values);
  clip(std::span(clipped).first(at), deviation);
  clip(std::span(clipped).subspan(at), deviation);
  return clipped;
}

SeededIntervals seeded_intervals(std::size_t size, std::size_t shortest) {
  SeededIntervals intervals;
  const auto whole = static_cast<double>(size);
  for (double layer = 0;; ++layer) {
    const double shrunk = std::pow(std::numbers::sqrt2, layer);
    const double length = whole / shrunk;
    if (length < static_cast<double>(shortest)) return intervals;
    const double count = 2 * std::ceil(shrunk) - 1;
    const double step = count > 1 ? (whole - length) / (count - 1) : 0;
    for (double i = 0; i < count; ++i) {
      const auto begin = static_cast<std::size_t>(std::floor(i * step));
      const auto end = static_cast<std::size_t>(std::ceil(i * step + length - 1e-9));
      intervals.emplace_back(begin, std::min(end, size));
    }
  }
}

Split largest_split(std::span<const double> values, const SeededIntervals& intervals,
                    std::size_t shortest) {
  const std::vector<double> sums = partial_sums(values);
  Split best;
  double best_square = 0;
  for (const auto& [begin, end] : intervals) {
    const auto length = static_cast<double>(end - begin);
    const double mean_of_all = (sums[end] - sums[begin]) / length;
    for (std::size_t at = begin + shortest; at + shortest <= end; ++at) {
      const auto left = static_cast<double>(at - begin);
      const double excess = sums[at] - sums[begin] - left * mean_of_all;
      const double squared = square(excess) * length / (left * (length - left));
      if (squared <= best_square) continue;
      best_square = squared;
      best.at = at;
    }
  }
  best.height = std::sqrt(best_square);
  return best;
}

PlausibleSplits plausible_splits(std::span<const double> values, std::size_t at) {
  const std::vector<double> sums = partial_sums(values);
  const auto size = static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) squares += square(value - sums.back() / size);
  // The mean is taken off, so that the difference below is not one of large numbers.
  const auto residuals = [&](std::size_t split) {
    const auto left = static_cast<double>(split);
    const double excess = sums[split] - left * sums.back() / size;
    return squares - square(excess) * size / (left * (size - left));
  };
  const double best = std::max(residuals(at), 0.0);
  const double most = best + kPlausible * best / std::max(size - 2, 1.0) + 1e-12 * squares;
  PlausibleSplits splits{at, at, residuals_of_line(values) < best};
  for (std::size_t split = 1; split < values.size(); ++split) {
    if (residuals(split) > most) continue;
    splits.first = std::min(splits.first, split);
    splits.last = std::max(splits.last, split);
  }
  return splits;
}

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
