#pragma once

#include <span>
#include <vector>

namespace ar3d {

/// Describes a closed interval; both ends NaN if there is none.
struct Interval {
  double low = 0;
  double high = 0;
  bool contains(double value) const { return low <= value && value <= high; }
  double width() const { return high - low; }
};

/// Returns the p-quantile, 0 <= p <= 1, with linear interpolation between order statistics (type 7
/// of Hyndman and Fan). NaN values are left out; NaN if nothing is left. Cost: O(k log k).
double quantile(std::vector<double> values, double p);
double median(std::vector<double> values);

/// Returns an interval that holds the median with 95 % or more, by order statistics (Conover,
/// Practical Nonparametric Statistics, 3.2); all values if they are fewer than six. O(k log k).
Interval median_interval(std::vector<double> values);
/// Gives the two-sided p of the sign test of so many differences below and above 0; 1 without any.
double sign_test(std::size_t below, std::size_t above);

/// Returns NaN for an empty list.
double mean(std::span<const double> values);

/// Returns the p-quantile of Student's t with df > 0 degrees of freedom; of the normal distribution
/// if df is infinite.
double student_t_quantile(double p, double df);
/// Returns P(F > value) for Fisher's F with the given degrees of freedom, all > 0 and value >= 0.
double fisher_f_tail(double value, double df_numerator, double df_denominator);

}  // namespace ar3d
