#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/analysis/statistics.h"
#include "ar3d/analysis/tally.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/store/columns/curves.h"

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

/// Is a fit as a linear map of the data: coefficient[j] = sum over s of projection[j][s] * y[s].
struct LinearFit {
  std::vector<double> coefficients;
  std::vector<std::vector<double>> projection;  ///< [coefficient][point]
  std::vector<std::vector<double>> hat;         ///< fitted[s] = sum over t of hat[s][t] * y[t]
  std::vector<double> residuals;                ///< y - fitted, by point
  double square_sum = 0;                        ///< of the residuals
};

/// Fits y[s] = sum over j of coefficient[j] * x[s][j] by ordinary least squares.
/// @param x  the regressors at every point; at least as many points as regressors.
/// @throws InternalError if the regressors are linearly dependent on these points. Cost: O(s^2 p +
/// p^3) for s points and p regressors.
LinearFit fit_linear(const std::vector<std::vector<double>>& x, const std::vector<double>& y);

/// Describes value = exp(log_factor) * n^exponent, or with logarithms * log(n)^log_exponent, fitted
/// to the means of the logarithms of each size, every size with the same weight: a size is a
/// cluster, whose graphs may share an error. Intervals hold with 95 %.
struct CurveFit {
  bool fitted = false;  ///< false with fewer sizes than coefficients
  double log_factor = 0;
  double exponent = 0;
  double log_exponent = 0;  ///< 0 in the pure power law
  Interval exponent_interval{kMissing, kMissing};
  Interval log_exponent_interval{kMissing, kMissing};
  double square_sum = 0;  ///< of the sizes' residuals
};

/// Fits a curve.
/// @param with_log  fits n^a log(n)^b instead of n^a; all n > 1 then.
/// @param intervals  false leaves them missing.
CurveFit fit_curve(std::span<const SizeSample> sizes, bool with_log, bool intervals);

/// Returns the Akaike weight, in [0, 1], of n^a log(n)^b among four models. The others are n^a; n^a
/// with a lower-order term of relative order n^(-1/2) or 1/n; and n^a with one smooth step (a cache
/// boundary) at any of the inner sizes. AICc is over the means of the sizes. @param sizes  at least
/// eight, all n > 1.
double log_weight(std::span<const SizeSample> sizes);

/// Says what may be said of a growth. The rules are numbered in docs/analysis.md, section Growth.
enum class Growth {
  power,          ///< n^a: the local exponent stays the same over the sizes
  power_and_log,  ///< n^a log^b n with a plausible b, and nothing else explains the bend
  apparent,       ///< an exponent over the fitted sizes, which says nothing about larger ones
  undecided,      ///< too few sizes, or no times that can be compared
};
/// Returns "power law", "power law with logarithm", "apparent exponent", "undecided"
const char* to_string(Growth growth);

/// Holds how one quantity of one curve grows with n.
struct ScalingEntry {
  CurveKey key;
  Quantity quantity{};
  std::vector<SizeSample> all;   ///< everything measured, for plots
  std::size_t censored = 0;      ///< rows that ended before they had a value
  std::vector<SizeSample> used;  ///< what was fitted: choose_sizes
  CurveFit power;                ///< n^a; a is the apparent exponent over the fitted sizes
  CurveFit with_log;             ///< n^a log^b n
  /// Holds the local exponent (slope in log-log axes) of the fitted parabola at the smallest and at
  /// the largest size; their difference, the drift, has an interval.
  double first_exponent = kMissing, last_exponent = kMissing;
  Interval drift{kMissing, kMissing};
  /// Holds the p-value of the F-test that neither a quadratic nor a cubic term is needed.
  double line_p = kMissing;
  /// Holds the same for a cubic term beside n^a log(n)^b.
  double with_log_p = kMissing;
  double log_weight = kMissing;  ///< ar3d::log_weight
  bool decided = false;          ///< the apparent exponent has an interval
  Growth growth = Growth::undecided;
  /// Says where a power law's exponent lies for larger n, too, if what is left of a lower-order
  /// term falls at least like n^(-1/2): power.exponent_interval widened by the drift at either end.
  Interval law_interval{kMissing, kMissing};
  std::string reason;  ///< why so, one sentence
  std::string next;    ///< which sizes and seeds would decide, in words; empty if nothing would
  std::vector<std::int64_t> next_sizes;  ///< n to add for that
};

/// Measures how far the used sizes are from a straight line in log-log axes: first_exponent to
/// with_log_p. @pre at least six sizes, all n > 1.
void measure_curvature(ScalingEntry& entry);

/// Is ScalingEntry::reason of a drawing time that no row of the timing phase tells.
inline constexpr const char* kUntimed = "no rows of the timing phase";

/// Fits one sample. Cost: O(s^2) for s sizes.
ScalingEntry fit_scaling(std::vector<SizeSample> all);

/// Returns every quantity that was measured in every curve, in the order of the file. Drawing times
/// are fitted where the curve has rows of the timing phase, and from these alone. Same numbers on
/// any thread count.
std::vector<ScalingEntry> scaling(const StudyTally& tally);

/// Returns the power of n in a theorem's bound on a quantity of the box; nothing for a drawing
/// time, and for one that promises no box.
std::optional<double> theorem_order(const SizeBound& theorem, Quantity quantity);

/// Takes back a power law above a theorem's bound c n^order, since it cannot last: where the whole
/// law_interval lies above, the exponent is an apparent one (docs/analysis.md, Growth, point 5).
void refuse_law_above(double order, ScalingEntry& entry);

}  // namespace ar3d
