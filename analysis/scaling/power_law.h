#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ar3d/analysis/scaling/bootstrap.h"
#include "ar3d/analysis/scaling/samples.h"

namespace ar3d {

struct FitOptions {
  std::size_t minimum_sizes = 8;  ///< fewer distinct sizes: no interval, "undecided"
  double minimum_span = 4;        ///< largest over smallest used n; less: "undecided"
  BootstrapOptions bootstrap;
};

/// value = exp(log_factor) * n^exponent, or with logarithms * log(n)^log_exponent.
struct CurveFit {
  bool fitted = false;  ///< false with fewer sizes than coefficients
  double log_factor = 0;
  double exponent = 0;
  double log_exponent = 0;  ///< 0 in the pure power law
  Interval exponent_interval{kMissing, kMissing};
  Interval log_exponent_interval{kMissing, kMissing};
  Spread spread = Spread::sizes;
  double aicc = kMissing;
  double log_value(double n) const;
};

/// Fits the size means of logarithms, weighted by their number of instances (equally where
/// Spread::sizes).
/// @param with_log  fits n^a log(n)^b instead of n^a; all n > 1 then.
/// @param intervals  false skips the bootstrap.
CurveFit fit_curve(const std::vector<SizeSample>& sizes, bool with_log, bool intervals,
                   const BootstrapOptions& options);

}  // namespace ar3d
