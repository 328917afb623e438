#pragma once

#include <cstddef>
#include <vector>

namespace ar3d {

/// One point of a weighted least-squares fit: y = sum over j of coefficient[j] * regressors[j].
struct FitPoint {
  std::vector<double> regressors;
  double y = 0;
  double weight = 1;
};

/// A fit as a linear map of the data: coefficient[j] = sum over s of projection[j][s] * y[s]. The
/// bootstrap only changes y, so it needs nothing but the projection.
struct LinearFit {
  std::vector<double> coefficients;
  std::vector<std::vector<double>> projection;  ///< [coefficient][point]
  std::vector<double> residuals;                ///< y - fitted, by point
  std::vector<double> leverages;                ///< diagonal of the hat matrix, by point
  double weighted_square_sum = 0;               ///< of the residuals
};

/// @param points  at least as many as regressors; positive weights.
/// @throws InternalError if the regressors are linearly dependent on these points.
/// Cost: O(s p^2 + p^3) for s points and p regressors.
LinearFit fit_linear(const std::vector<FitPoint>& points);

}  // namespace ar3d
