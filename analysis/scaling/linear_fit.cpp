#include "ar3d/analysis/scaling/linear_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/store/columns/run_record.h"

namespace ar3d {
namespace {

using Matrix = std::vector<std::vector<double>>;

/// A point that decides its own fitted value has leverage 1 and tells nothing about the errors.
constexpr double kLeastFreedom = 1e-9;

/// X^T X.
Matrix normal_matrix(const std::vector<FitPoint>& points, std::size_t p) {
  Matrix normal(p, std::vector<double>(p, 0));
  for (const FitPoint& point : points) {
    for (std::size_t i = 0; i < p; ++i) {
      for (std::size_t j = 0; j < p; ++j) {
        normal[i][j] += point.regressors[i] * point.regressors[j];
      }
    }
  }
  return normal;
}

/// Gauss-Jordan with partial pivoting; p is two to four here.
Matrix inverse(Matrix a) {
  const std::size_t p = a.size();
  Matrix result(p, std::vector<double>(p, 0));
  for (std::size_t i = 0; i < p; ++i) result[i][i] = 1;
  for (std::size_t column = 0; column < p; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < p; ++row) {
      if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
    }
    expect(std::abs(a[pivot][column]) > 0, "the regressors of a fit are independent");
    std::swap(a[pivot], a[column]);
    std::swap(result[pivot], result[column]);
    for (std::size_t row = 0; row < p; ++row) {
      const double factor =
          (row == column ? a[row][column] - 1 : a[row][column]) / a[column][column];
      for (std::size_t k = 0; k < p; ++k) {
        a[row][k] -= factor * a[column][k];
        result[row][k] -= factor * result[column][k];
      }
    }
  }
  return result;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

LinearFit fit_linear(const std::vector<FitPoint>& points) {
  const std::size_t p = points.at(0).regressors.size(), count = points.size();
  expect(count >= p, "a fit has at least as many points as coefficients");
  const Matrix covariance = inverse(normal_matrix(points, p));
  LinearFit fit;
  fit.projection.assign(p, std::vector<double>(count, 0));
  fit.coefficients.assign(p, 0);
  for (std::size_t j = 0; j < p; ++j) {
    for (std::size_t s = 0; s < count; ++s) {
      fit.projection[j][s] = dot(covariance[j], points[s].regressors);
      fit.coefficients[j] += fit.projection[j][s] * points[s].y;
    }
  }
  fit.hat.assign(count, std::vector<double>(count, 0));
  for (std::size_t s = 0; s < count; ++s) {
    const std::vector<double>& x = points[s].regressors;
    for (std::size_t t = 0; t < count; ++t) {
      for (std::size_t j = 0; j < p; ++j) fit.hat[s][t] += x[j] * fit.projection[j][t];
    }
    fit.residuals.push_back(points[s].y - dot(x, fit.coefficients));
    fit.square_sum += fit.residuals[s] * fit.residuals[s];
  }
  return fit;
}

Interval robust_interval(const LinearFit& fit, std::size_t coefficient, double confidence) {
  const std::size_t count = fit.residuals.size();
  if (count <= fit.coefficients.size()) return {kMissing, kMissing};
  const std::vector<double>& projection = fit.projection[coefficient];
  std::vector<double> scaled(count);  // projection / sqrt(1 - leverage)
  double variance = 0;
  for (std::size_t s = 0; s < count; ++s) {
    scaled[s] = projection[s] / std::sqrt(std::max(kLeastFreedom, 1 - fit.hat[s][s]));
    variance += scaled[s] * scaled[s] * fit.residuals[s] * fit.residuals[s];
  }
  // With errors of one variance the estimate is a quadratic form with this trace and this trace of
  // its square; Satterthwaite's degrees of freedom match a chi-square to both.
  double trace = 0, square_trace = 0;
  for (std::size_t s = 0; s < count; ++s) {
    for (std::size_t t = 0; t < count; ++t) {
      const double entry = scaled[s] * scaled[t] * ((s == t ? 1 : 0) - fit.hat[s][t]);
      trace += s == t ? entry : 0;
      square_trace += entry * entry;
    }
  }
  if (!(square_trace > 0)) return {kMissing, kMissing};
  const double df = std::max(1.0, trace * trace / square_trace);
  const double half = student_t_quantile((1 + confidence) / 2, df) * std::sqrt(variance);
  return {fit.coefficients[coefficient] - half, fit.coefficients[coefficient] + half};
}

}  // namespace ar3d
