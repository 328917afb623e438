#include "ar3d/analysis/scaling/power_law.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace ar3d {
namespace {

/// Squares of residuals below this are rounding: logarithms are near 10, doubles have 16 digits.
constexpr double kRoundingSquare = 1e-26;

using Regressor = std::function<double(double log_n)>;

std::vector<FitPoint> fit_points(std::span<const SizeSample> sizes,
                                 const std::vector<Regressor>& regressors) {
  std::vector<FitPoint> points;
  for (const SizeSample& size : sizes) {
    FitPoint point{{1}, size.mean_log()};
    for (const Regressor& regressor : regressors) {
      point.regressors.push_back(regressor(std::log(static_cast<double>(size.n))));
    }
    points.push_back(std::move(point));
  }
  return points;
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
    const double place = std::log(static_cast<double>(sizes[s].n));
    const Regressor step = [=](double x) { return std::tanh((x - place) / std::log(2.0)); };
    best = std::min(best, corrected_akaike(fit_linear(fit_points(sizes, {identity, step})), 4));
  }
  return best;
}

}  // namespace

double CurveFit::log_value(double n) const {
  const double log_n = std::log(n);
  const double log_part = log_exponent == 0 ? 0 : log_exponent * std::log(log_n);
  return log_factor + exponent * log_n + log_part;
}

double CurveFit::typical_residual(std::size_t sizes) const {
  return std::sqrt(square_sum / static_cast<double>(sizes));
}

CurveFit fit_curve(std::span<const SizeSample> sizes, bool with_log, bool intervals,
                   double confidence) {
  CurveFit curve;
  std::vector<Regressor> regressors = {identity};
  if (with_log) regressors.push_back(log_log);
  if (sizes.size() <= regressors.size()) return curve;
  const LinearFit fit = fit_linear(fit_points(sizes, regressors));
  curve.fitted = true;
  curve.log_factor = fit.coefficients[0];
  curve.exponent = fit.coefficients[1];
  if (with_log) curve.log_exponent = fit.coefficients[2];
  curve.square_sum = fit.square_sum;
  if (!intervals) return curve;
  curve.exponent_interval = robust_interval(fit, 1, confidence);
  if (with_log) curve.log_exponent_interval = robust_interval(fit, 2, confidence);
  return curve;
}

Curvature curvature(std::span<const SizeSample> sizes, double confidence) {
  const double centre = centre_of(sizes);
  const Regressor linear = power_of(centre, 1), square = power_of(centre, 2),
                  cube = power_of(centre, 3);
  const LinearFit line = fit_linear(fit_points(sizes, {linear}));
  const LinearFit parabola = fit_linear(fit_points(sizes, {linear, square}));
  const LinearFit cubic = fit_linear(fit_points(sizes, {linear, square, cube}));
  const LinearFit with_log = fit_linear(fit_points(sizes, {linear, log_log}));
  const LinearFit with_both = fit_linear(fit_points(sizes, {linear, log_log, cube}));
  const double first = std::log(static_cast<double>(sizes.front().n)) - centre;
  const double last = std::log(static_cast<double>(sizes.back().n)) - centre;
  Curvature result;
  result.first_exponent = parabola.coefficients[1] + 2 * parabola.coefficients[2] * first;
  result.last_exponent = parabola.coefficients[1] + 2 * parabola.coefficients[2] * last;
  const Interval bend = robust_interval(parabola, 2, confidence);
  result.drift = {2 * bend.low * (last - first), 2 * bend.high * (last - first)};
  result.line_p = nested_p(line, cubic);
  result.with_log_p = nested_p(with_log, with_both);
  return result;
}

double log_weight(std::span<const SizeSample> sizes) {
  const auto criterion = [&](const std::vector<Regressor>& regressors) {
    return corrected_akaike(fit_linear(fit_points(sizes, regressors)), regressors.size() + 1);
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
