#pragma once

#include <span>
#include <vector>

namespace ar3d {

/// A closed interval; both ends NaN if there is none.
struct Interval {
  double low = 0;
  double high = 0;
  bool contains(double value) const { return low <= value && value <= high; }
  double width() const { return high - low; }
};

/// The p-quantile, 0 <= p <= 1, with linear interpolation between order statistics (type 7 of
/// Hyndman and Fan). NaN values are left out; NaN if nothing is left. Cost: O(k log k).
double quantile(std::vector<double> values, double p);
double median(std::vector<double> values);

/// NaN for an empty list.
double mean(std::span<const double> values);

/// The p-quantile of Student's t with df > 0 degrees of freedom; of the normal distribution if df
/// is infinite.
double student_t_quantile(double p, double df);
/// P(F > value) for Fisher's F with the given degrees of freedom, all > 0 and value >= 0.
double fisher_f_tail(double value, double df_numerator, double df_denominator);

}  // namespace ar3d
