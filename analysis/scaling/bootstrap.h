#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ar3d/analysis/scaling/linear_fit.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d {

/// Where the spread comes from that an interval is made of.
enum class Spread {
  instances,  ///< the scatter of the instances of each size explains how far the sizes are from the
              ///< curve
  sizes,      ///< one instance a size, or the sizes scatter more than their instances explain
};

struct BootstrapOptions {
  double confidence = 0.95;
  std::size_t replicates = 2000;
  std::uint64_t seed = 1;
};

/// Chooses the spread: `instances` if every size has at least two and the F-test of lack of fit
/// does not reject at 1 %.
/// @param values  logarithms by size, the fit's points being their means with their counts as
/// weights.
Spread choose_spread(const std::vector<std::vector<double>>& values, const LinearFit& fit);

/// Confidence interval of coefficient j by the basic bootstrap over instances: within each size the
/// deviations from the size's mean are drawn again with replacement, inflated by sqrt(k / (k - 1))
/// for k instances, and the interval is widened by Student's t over normal with Welch's
/// degrees of freedom (few instances are known to lie). Cost: O(replicates * instances).
Interval interval_over_instances(const std::vector<std::vector<double>>& values,
                                 const LinearFit& fit, std::size_t coefficient,
                                 const BootstrapOptions& options);

/// The same over sizes: residuals divided by sqrt(1 - leverage), centred, and t with sizes -
/// coefficients degrees.
/// @param fit  of the size means with equal weights.
Interval interval_over_sizes(const LinearFit& fit, std::size_t coefficient,
                             const BootstrapOptions& options);

}  // namespace ar3d
