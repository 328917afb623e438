#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ar3d/analysis/scaling/samples.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d {

/// Describes one point of a least-squares fit: y = sum over j of coefficient[j] * regressors[j].
struct FitPoint {
  std::vector<double> regressors;
  double y = 0;
};

/// Is a fit as a linear map of the data: coefficient[j] = sum over s of projection[j][s] * y[s].
struct LinearFit {
  std::vector<double> coefficients;
  std::vector<std::vector<double>> projection;  ///< [coefficient][point]
  std::vector<std::vector<double>> hat;         ///< fitted[s] = sum over t of hat[s][t] * y[t]
  std::vector<double> residuals;                ///< y - fitted, by point
  double square_sum = 0;                        ///< of the residuals
};

/// Fits by ordinary least squares.
/// @param points  at least as many as regressors.
/// @throws InternalError if the regressors are linearly dependent on these points. Cost: O(s^2 p +
/// p^3) for s points and p regressors.
LinearFit fit_linear(const std::vector<FitPoint>& points);

/// Confidence interval of coefficient j that holds for independent errors of unequal variances: the
/// HC2 estimate of its variance with Student's t and the degrees of freedom of Bell and McCaffrey
/// (Imbens and Kolesár, "Robust standard errors in small samples", Review of Economics and
/// Statistics 98, 2016). Where a point is the mean of a cluster this is the cluster-robust interval
/// for few clusters: whatever the members of a cluster have in common is part of its error.
/// @param fit  with more points than coefficients; else both ends are missing.
/// @param confidence  in (0, 1). Cost: O(s^2).
Interval robust_interval(const LinearFit& fit, std::size_t coefficient, double confidence);

struct FitOptions {
  std::size_t minimum_sizes = 8;  ///< fewer distinct sizes: no interval, "undecided"
  double minimum_span = 4;        ///< largest over smallest used n; less: "undecided"
  double confidence = 0.95;       ///< of every interval
};

/// Describes value = exp(log_factor) * n^exponent, or with logarithms * log(n)^log_exponent, fitted
/// to the means of the logarithms of each size, every size with the same weight: a size is a
/// cluster, whose graphs may share an error. Intervals are robust_interval's.
struct CurveFit {
  bool fitted = false;  ///< false with fewer sizes than coefficients
  double log_factor = 0;
  double exponent = 0;
  double log_exponent = 0;  ///< 0 in the pure power law
  Interval exponent_interval{kMissing, kMissing};
  Interval log_exponent_interval{kMissing, kMissing};
  double square_sum = 0;  ///< of the sizes' residuals
  /// Returns the square root of the mean squared residual of `sizes` sizes.
  double typical_residual(std::size_t sizes) const;
};

/// @param with_log  fits n^a log(n)^b instead of n^a; all n > 1 then.
/// @param intervals  false leaves them missing.
CurveFit fit_curve(std::span<const SizeSample> sizes, bool with_log, bool intervals,
                   double confidence = 0.95);

/// Holds how far the sizes are from a straight line in log-log axes.
struct Curvature {
  /// Holds the local exponent (slope in log-log axes) of the fitted parabola at the smallest and at
  /// the largest size; their difference, the drift, has an interval.
  double first_exponent = kMissing;
  double last_exponent = kMissing;
  Interval drift{kMissing, kMissing};
  /// Holds the p-value of the F-test that neither a quadratic nor a cubic term is needed.
  double line_p = kMissing;
  /// Holds the same for a cubic term beside n^a log(n)^b.
  double with_log_p = kMissing;
};

/// @param sizes  at least six, all n > 1.
Curvature curvature(std::span<const SizeSample> sizes, double confidence = 0.95);

/// Akaike weight, in [0, 1], of n^a log(n)^b among: n^a; n^a log(n)^b; n^a with a lower-order term
/// of relative order n^(-1/2) or 1/n; and n^a with one smooth step (a cache boundary) at any of the
/// inner sizes. AICc over the means of the sizes. @param sizes  at least eight, all n > 1.
double log_weight(std::span<const SizeSample> sizes);

}  // namespace ar3d
