#pragma once

#include <cstddef>
#include <vector>

#include "ar3d/analysis/statistics.h"

namespace ar3d {

/// One point of a least-squares fit: y = sum over j of coefficient[j] * regressors[j].
struct FitPoint {
  std::vector<double> regressors;
  double y = 0;
};

/// A fit as a linear map of the data: coefficient[j] = sum over s of projection[j][s] * y[s].
struct LinearFit {
  std::vector<double> coefficients;
  std::vector<std::vector<double>> projection;  ///< [coefficient][point]
  std::vector<std::vector<double>> hat;         ///< fitted[s] = sum over t of hat[s][t] * y[t]
  std::vector<double> residuals;                ///< y - fitted, by point
  double square_sum = 0;                        ///< of the residuals
};

/// Ordinary least squares.
/// @param points  at least as many as regressors.
/// @throws InternalError if the regressors are linearly dependent on these points.
/// Cost: O(s^2 p + p^3) for s points and p regressors.
LinearFit fit_linear(const std::vector<FitPoint>& points);

/// Confidence interval of coefficient j that holds for independent errors of unequal variances: the
/// HC2 estimate of its variance with Student's t and the degrees of freedom of Bell and McCaffrey
/// (Imbens and Kolesár, "Robust standard errors in small samples", Review of Economics and
/// Statistics 98, 2016). Where a point is the mean of a cluster this is the cluster-robust interval
/// for few clusters: whatever the members of a cluster have in common is part of its error.
/// @param fit  with more points than coefficients; else both ends are missing.
/// @param confidence  in (0, 1). Cost: O(s^2).
Interval robust_interval(const LinearFit& fit, std::size_t coefficient, double confidence);

}  // namespace ar3d
