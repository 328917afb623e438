#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "ar3d/analysis/tally.h"

namespace ar3d {

/// Returns "longest side", "x extent", …, "volume", "drawing time"
const char* name_of(Quantity quantity);

/// Returns the natural logarithm of the theorem's bound on the quantity; missing for times and
/// where the graph has no bound.
double log_bound(const DrawnGraph& graph, Quantity quantity);

/// Describes all graphs of one n, or a uniform sample of them; never empty.
struct SizeSample {
  std::int64_t n = 0;
  std::int64_t requested_n =
      0;  ///< what the study asked for; families make the nearest n they have
  /// Holds of each graph the logarithm of its value and its first ok row.
  std::vector<std::pair<double, std::size_t>> instances;
  double mean_of_all = kMissing;  ///< of the logarithms, where `instances` is a sample
  double log_bound = kMissing;    ///< of the first instance
  /// Is true if some instance of this size ended in timeout, out of memory or a crash: what is here
  /// are the fast ones only.
  bool censored = false;
  std::vector<double> log_values() const;
  double mean_log() const;  ///< of all graphs, in the sample or not
};

/// Returns the measured sizes of one curve in increasing order of n >= 1; only ok rows count. Times
/// are those of the timing phase if the curve has such rows, else of the metrics phase (for plots).
std::vector<SizeSample> samples(const CurveTally& curve, Quantity quantity);

/// Returns the sizes that a fit uses: those without censored instances, and of them those of at
/// least the square root of the largest one, but so many that `minimum_sizes` stay.
std::vector<SizeSample> choose_sizes(const std::vector<SizeSample>& all, std::size_t minimum_sizes);

}  // namespace ar3d
