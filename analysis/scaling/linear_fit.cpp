#include "ar3d/analysis/scaling/linear_fit.h"

#include <cmath>
#include <utility>

#include "ar3d/model/error.h"

namespace ar3d {
namespace {

using Matrix = std::vector<std::vector<double>>;

/// X^T W X.
Matrix normal_matrix(const std::vector<FitPoint>& points, std::size_t p) {
  Matrix normal(p, std::vector<double>(p, 0));
  for (const FitPoint& point : points) {
    for (std::size_t i = 0; i < p; ++i) {
      for (std::size_t j = 0; j < p; ++j) {
        normal[i][j] += point.weight * point.regressors[i] * point.regressors[j];
      }
    }
  }
  return normal;
}

/// Gauss-Jordan with partial pivoting; p is two or three here.
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
  const std::size_t p = points.at(0).regressors.size();
  expect(points.size() >= p, "a fit has at least as many points as coefficients");
  const Matrix covariance = inverse(normal_matrix(points, p));
  LinearFit fit;
  fit.projection.assign(p, std::vector<double>(points.size(), 0));
  fit.coefficients.assign(p, 0);
  for (std::size_t j = 0; j < p; ++j) {
    for (std::size_t s = 0; s < points.size(); ++s) {
      fit.projection[j][s] = points[s].weight * dot(covariance[j], points[s].regressors);
      fit.coefficients[j] += fit.projection[j][s] * points[s].y;
    }
  }
  for (std::size_t s = 0; s < points.size(); ++s) {
    const std::vector<double>& x = points[s].regressors;
    double leverage = 0;
    for (std::size_t j = 0; j < p; ++j) leverage += x[j] * fit.projection[j][s];
    fit.leverages.push_back(leverage);
    fit.residuals.push_back(points[s].y - dot(x, fit.coefficients));
    fit.weighted_square_sum += points[s].weight * fit.residuals[s] * fit.residuals[s];
  }
  return fit;
}

}  // namespace ar3d
