#pragma once

#include <vector>

namespace ar3d {

/// Half the width of the 95 % confidence interval of the median, divided by the median. The
/// interval lies between two order statistics, from the binomial distribution: it holds for any
/// continuous distribution. Infinite for fewer than six values (no such interval) or a median that
/// is not positive.
double median_precision(std::vector<double> values);

}  // namespace ar3d
