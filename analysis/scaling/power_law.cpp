#include "ar3d/analysis/scaling/power_law.h"

#include <cmath>

namespace ar3d {
namespace {

std::vector<FitPoint> fit_points(const std::vector<SizeSample>& sizes, bool with_log,
                                 bool equal_weights) {
  std::vector<FitPoint> points;
  for (const SizeSample& size : sizes) {
    const double log_n = std::log(static_cast<double>(size.n));
    const std::vector<double> values = size.log_values();
    FitPoint point{{1, log_n}, mean(values), 1};
    if (with_log) point.regressors.push_back(std::log(log_n));
    if (!equal_weights) point.weight = static_cast<double>(values.size());
    points.push_back(std::move(point));
  }
  return points;
}

/// Akaike's criterion for least squares over all instances, with its correction for few of them;
/// missing when there are too few for it. A perfect fit gives minus infinity.
double corrected_akaike(const LinearFit& fit, const std::vector<std::vector<double>>& values) {
  double square_sum = fit.weighted_square_sum;
  std::size_t count = 0;
  for (const std::vector<double>& size : values) {
    if (size.size() > 1) square_sum += variance(size) * static_cast<double>(size.size() - 1);
    count += size.size();
  }
  const double s = static_cast<double>(count);
  const double k = static_cast<double>(fit.coefficients.size() + 1);  // and the variance
  if (s - k - 1 <= 0) return kMissing;
  return s * std::log(square_sum / s) + 2 * k + 2 * k * (k + 1) / (s - k - 1);
}

void take_coefficients(const LinearFit& fit, CurveFit& curve) {
  curve.fitted = true;
  curve.log_factor = fit.coefficients[0];
  curve.exponent = fit.coefficients[1];
  if (fit.coefficients.size() > 2) curve.log_exponent = fit.coefficients[2];
}

}  // namespace

double CurveFit::log_value(double n) const {
  const double log_n = std::log(n);
  const double log_part = log_exponent == 0 ? 0 : log_exponent * std::log(log_n);
  return log_factor + exponent * log_n + log_part;
}

CurveFit fit_curve(const std::vector<SizeSample>& sizes, bool with_log, bool intervals,
                   const BootstrapOptions& options) {
  CurveFit curve;
  const std::size_t coefficients = with_log ? 3 : 2;
  if (sizes.size() < coefficients) return curve;
  std::vector<std::vector<double>> values;
  for (const SizeSample& size : sizes) values.push_back(size.log_values());
  LinearFit fit = fit_linear(fit_points(sizes, with_log, false));
  curve.spread = choose_spread(values, fit);
  curve.aicc = corrected_akaike(fit, values);
  if (curve.spread == Spread::sizes) fit = fit_linear(fit_points(sizes, with_log, true));
  take_coefficients(fit, curve);
  if (!intervals || sizes.size() == coefficients) return curve;
  const auto interval = [&](std::size_t j) {
    return curve.spread == Spread::instances ? interval_over_instances(values, fit, j, options)
                                             : interval_over_sizes(fit, j, options);
  };
  curve.exponent_interval = interval(1);
  if (with_log) curve.log_exponent_interval = interval(2);
  return curve;
}

}  // namespace ar3d
