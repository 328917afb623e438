#include "ar3d/analysis/history/split.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ar3d/analysis/statistics.h"

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

}  // namespace ar3d
