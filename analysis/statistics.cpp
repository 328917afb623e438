// Small statistics that several analyses share. Missing values are NaN and are left out, so that
// one failed row does not spoil a median.
#include "ar3d/analysis/statistics.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace ar3d {
namespace {
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
}  // namespace

double quantile(std::vector<double> values, double p) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return kNone;
  std::sort(values.begin(), values.end());
  const double rank = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const double fraction = rank - static_cast<double>(below);
  if (fraction == 0) return values[below];  // also keeps infinities out of the interpolation
  return values[below] + fraction * (values[below + 1] - values[below]);
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

Interval median_interval(std::vector<double> values) {
  if (values.empty()) return {kNone, kNone};
  std::sort(values.begin(), values.end());
  const boost::math::binomial below(static_cast<double>(values.size()), 0.5);
  std::size_t out = 0;  // values left out on either side
  while (out + 1 < values.size() / 2 &&
         boost::math::cdf(below, static_cast<double>(out)) <= 0.025) {
    ++out;
  }
  return {values[out], values[values.size() - 1 - out]};
}

double sign_test(std::size_t below, std::size_t above) {
  if (below + above == 0) return 1;
  const boost::math::binomial half(static_cast<double>(below + above), 0.5);
  return std::min(1.0, 2 * boost::math::cdf(half, static_cast<double>(std::min(below, above))));
}

double mean(std::span<const double> values) {
  if (values.empty()) return kNone;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double student_t_quantile(double p, double df) {
  if (std::isinf(df)) return boost::math::quantile(boost::math::normal(), p);
  return boost::math::quantile(boost::math::students_t(df), p);
}

double fisher_f_tail(double value, double df_numerator, double df_denominator) {
  const boost::math::fisher_f distribution(df_numerator, df_denominator);
  return boost::math::cdf(boost::math::complement(distribution, value));
}

}  // namespace ar3d
