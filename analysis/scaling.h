#pragma once

#include <string>
#include <vector>

#include "ar3d/analysis/cells.h"
#include "ar3d/analysis/scaling/power_law.h"
#include "ar3d/analysis/scaling/samples.h"

namespace ar3d {

enum class Growth {
  power,          ///< n^a; a factor log^b n, if any, has |b| < 1/2
  power_and_log,  ///< n^a log^b n with b != 0
  undecided,
};
/// "power law", "power law with logarithm", "undecided"
const char* to_string(Growth growth);

/// What more to measure so that an undecided answer becomes one; both empty if it is decided.
struct NextStudy {
  std::vector<std::int64_t> sizes;  ///< n to add
  std::size_t seeds = 0;            ///< graphs of every size, old and new; 0: as many as there are
};

/// How one quantity of one cell grows with n.
struct ScalingEntry {
  CellKey key;
  Quantity quantity{};
  std::vector<SizeSample> all;        ///< everything measured, for plots
  std::vector<CensoredRow> censored;  ///< rows that ended before they had a value
  FitSizes sizes;                     ///< what was fitted
  CurveFit power;                     ///< n^a; a is the apparent exponent over the fitted sizes
  CurveFit with_log;                  ///< n^a log^b n
  double log_weight = kMissing;       ///< Akaike weight of with_log against power, in [0, 1]
  bool decided = false;               ///< enough sizes for the exponent's interval
  Growth growth = Growth::undecided;
  std::string reason;  ///< why so, one sentence
  std::string next;    ///< which sizes and seeds would decide, in words; empty if decided
  NextStudy next_study;
};

/// Fits one sample. Cost: O(replicates * instances).
ScalingEntry fit_scaling(std::vector<SizeSample> all, const FitOptions& options = {});

/// Every quantity that was measured in every cell, in the order of the file. Same numbers on any
/// thread count.
std::vector<ScalingEntry> scaling(const Results& results, const FitOptions& options = {});

}  // namespace ar3d
