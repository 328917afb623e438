// Least squares with robust intervals, and the laws that are fitted with it.
#include "ar3d/analysis/scaling/scaling.h"

namespace ar3d {

namespace {

using Matrix = std::vector<std::vector<double>>;

/// A point that decides its own fitted value has leverage 1 and tells nothing about the errors.
constexpr double kLeastFreedom = 1e-9;

/// X^T X.
Matrix normal_matrix(const Matrix& x, std::size_t p) {
  Matrix normal(p, std::vector<double>(p, 0));
  for (const std::vector<double>& point : x) {
    for (std::size_t i = 0; i < p; ++i) {
      for (std::size_t j = 0; j < p; ++j) normal[i][j] += point[i] * point[j];
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

/// Squares of residuals below this are rounding: logarithms are near 10, doubles have 16 digits.
constexpr double kRoundingSquare = 1e-26;

using Regressor = std::function<double(double log_n)>;

/// The means of the logarithms of the sizes, fitted by a constant and these.
LinearFit fit_sizes(std::span<const SizeSample> sizes, const std::vector<Regressor>& regressors) {
  Matrix x;
  std::vector<double> y;
  for (const SizeSample& size : sizes) {
    std::vector<double>& point = x.emplace_back(std::vector<double>{1});
    for (const Regressor& regressor : regressors) {
      point.push_back(regressor(std::log(static_cast<double>(size.n))));
    }
    y.push_back(size.mean_log());
  }
  return fit_linear(x, y);
}

double identity(double x) { return x; }
double log_log(double x) { return std::log(x); }

/// The middle of the sizes in log n; polynomials around it are well conditioned.
double centre_of(std::span<const SizeSample> sizes) {
  double sum = 0;
  for (const SizeSample& size : sizes) sum += std::log(static_cast<double>(size.n));
  return sum / static_cast<double>(sizes.size());
}

Regressor power_of(double centre, int exponent) {
  return [=](double x) { return std::pow(x - centre, exponent); };
}

double floored(double square_sum) { return std::max(square_sum, kRoundingSquare); }

/// p-value of the F-test of a fit within one of more coefficients.
double nested_p(const LinearFit& small, const LinearFit& large) {
  const double more = static_cast<double>(large.coefficients.size() - small.coefficients.size());
  const double df = static_cast<double>(large.residuals.size() - large.coefficients.size());
  const double gain = floored(small.square_sum) - floored(large.square_sum);
  const double ratio = std::max(0.0, gain / more) / (floored(large.square_sum) / df);
  return fisher_f_tail(ratio, more, df);
}

/// Akaike's criterion with its correction for few points; infinite if there are too few of them.
/// @param parameters  coefficients and whatever else was chosen by the data.
double corrected_akaike(const LinearFit& fit, std::size_t parameters) {
  const double s = static_cast<double>(fit.residuals.size());
  const double k = static_cast<double>(parameters + 1);  // and the variance
  if (s - k - 1 <= 0) return std::numeric_limits<double>::infinity();
  return s * std::log(floored(fit.square_sum) / s) + 2 * k + 2 * k * (k + 1) / (s - k - 1);
}

/// The best smooth step, two octaves wide, at an inner size.
double step_akaike(std::span<const SizeSample> sizes) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t s = 1; s + 1 < sizes.size(); ++s) {
    const double centre = std::log(static_cast<double>(sizes[s].n));
    const Regressor step = [=](double x) { return std::tanh((x - centre) / std::log(2.0)); };
    best = std::min(best, corrected_akaike(fit_sizes(sizes, {identity, step}), 4));
  }
  return best;
}

/// Returns a 95 % confidence interval of a coefficient that holds for independent errors of unequal
/// variances. It is the HC2 estimate of its variance with Student's t and the degrees of freedom of
/// Bell and McCaffrey (Imbens and Kolesár, "Robust standard errors in small samples", Review of
/// Economics and Statistics 98, 2016). Where a point is the mean of a cluster this is the
/// cluster-robust interval for few clusters: whatever the members of a cluster have in common is
/// part of its error. Both ends are missing without more points than coefficients. Cost: O(s^2).
Interval robust_interval(const LinearFit& fit, std::size_t coefficient) {
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
  const double half = student_t_quantile(0.975, df) * std::sqrt(variance);
  return {fit.coefficients[coefficient] - half, fit.coefficients[coefficient] + half};
}

}  // namespace

LinearFit fit_linear(const Matrix& x, const std::vector<double>& y) {
  const std::size_t p = x.at(0).size(), count = x.size();
  expect(count >= p, "a fit has at least as many points as coefficients");
  const Matrix covariance = inverse(normal_matrix(x, p));
  LinearFit fit;
  fit.projection.assign(p, std::vector<double>(count, 0));
  fit.coefficients.assign(p, 0);
  for (std::size_t j = 0; j < p; ++j) {
    for (std::size_t s = 0; s < count; ++s) {
      fit.projection[j][s] = dot(covariance[j], x[s]);
      fit.coefficients[j] += fit.projection[j][s] * y[s];
    }
  }
  fit.hat.assign(count, std::vector<double>(count, 0));
  for (std::size_t s = 0; s < count; ++s) {
    for (std::size_t t = 0; t < count; ++t) {
      for (std::size_t j = 0; j < p; ++j) fit.hat[s][t] += x[s][j] * fit.projection[j][t];
    }
    fit.residuals.push_back(y[s] - dot(x[s], fit.coefficients));
    fit.square_sum += fit.residuals[s] * fit.residuals[s];
  }
  return fit;
}

CurveFit fit_curve(std::span<const SizeSample> sizes, bool with_log, bool intervals) {
  CurveFit curve;
  std::vector<Regressor> regressors = {identity};
  if (with_log) regressors.push_back(log_log);
  if (sizes.size() <= regressors.size()) return curve;
  const LinearFit fit = fit_sizes(sizes, regressors);
  curve.fitted = true;
  curve.log_factor = fit.coefficients[0];
  curve.exponent = fit.coefficients[1];
  if (with_log) curve.log_exponent = fit.coefficients[2];
  curve.square_sum = fit.square_sum;
  if (!intervals) return curve;
  curve.exponent_interval = robust_interval(fit, 1);
  if (with_log) curve.log_exponent_interval = robust_interval(fit, 2);
  return curve;
}

void measure_curvature(ScalingEntry& entry) {
  const std::vector<SizeSample>& sizes = entry.used;
  const double centre = centre_of(sizes);
  const Regressor linear = power_of(centre, 1), square = power_of(centre, 2),
                  cube = power_of(centre, 3);
  const LinearFit line = fit_sizes(sizes, {linear});
  const LinearFit parabola = fit_sizes(sizes, {linear, square});
  const LinearFit cubic = fit_sizes(sizes, {linear, square, cube});
  const LinearFit with_log = fit_sizes(sizes, {linear, log_log});
  const LinearFit with_both = fit_sizes(sizes, {linear, log_log, cube});
  const double first = std::log(static_cast<double>(sizes.front().n)) - centre;
  const double last = std::log(static_cast<double>(sizes.back().n)) - centre;
  entry.first_exponent = parabola.coefficients[1] + 2 * parabola.coefficients[2] * first;
  entry.last_exponent = parabola.coefficients[1] + 2 * parabola.coefficients[2] * last;
  const Interval bend = robust_interval(parabola, 2);
  entry.drift = {2 * bend.low * (last - first), 2 * bend.high * (last - first)};
  entry.line_p = nested_p(line, cubic);
  entry.with_log_p = nested_p(with_log, with_both);
}

double log_weight(std::span<const SizeSample> sizes) {
  const auto criterion = [&](const std::vector<Regressor>& regressors) {
    return corrected_akaike(fit_sizes(sizes, regressors), regressors.size() + 1);
  };
  const double centre = centre_of(sizes);
  const auto lower_order = [=](double order) -> Regressor {
    return [=](double x) { return std::exp(-order * (x - centre)); };
  };
  const double with_log = criterion({identity, log_log});
  const std::vector<double> others = {criterion({identity}),
                                      criterion({identity, lower_order(0.5)}),
                                      criterion({identity, lower_order(1)}), step_akaike(sizes)};
  double sum = 1;
  for (const double other : others) sum += std::exp(std::min(700.0, (with_log - other) / 2));
  return std::isinf(with_log) ? 0 : 1 / sum;
}

}  // namespace ar3d
