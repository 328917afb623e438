#include "ar3d/bench/run/precision.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ar3d {
namespace {

// The largest k with P(at most k - 1 of n fair coins show heads) <= 2.5 %: the interval from the
// k-th smallest to the k-th largest value has at least 95 % confidence. 0 if there is none.
std::size_t order_of_bound(std::size_t n) {
  double log_probability = -static_cast<double>(n) * std::log(2.0);  // of exactly k heads
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) {
    sum += std::exp(log_probability);
    if (sum > 0.025) return k;
    log_probability += std::log(static_cast<double>(n - k)) - std::log(static_cast<double>(k + 1));
  }
  return 0;
}

}  // namespace

double median_precision(std::vector<double> values) {
  const std::size_t n = values.size();
  const std::size_t bound = order_of_bound(n);
  if (bound == 0) return std::numeric_limits<double>::infinity();
  std::sort(values.begin(), values.end());
  const double median = (values[(n - 1) / 2] + values[n / 2]) / 2;
  if (!(median > 0)) return std::numeric_limits<double>::infinity();
  return (values[n - bound] - values[bound - 1]) / 2 / median;
}

}  // namespace ar3d
