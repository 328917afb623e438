#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ar3d/analysis/scaling/power_law.h"
#include "ar3d/analysis/scaling/samples.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/store/columns/curves.h"

namespace ar3d {

/// Says what may be said of a growth. The rules are numbered in docs/analysis.md, section Growth.
enum class Growth {
  power,          ///< n^a: the local exponent stays the same over the sizes
  power_and_log,  ///< n^a log^b n with a plausible b, and nothing else explains the bend
  apparent,       ///< an exponent over the fitted sizes, which says nothing about larger ones
  undecided,      ///< too few sizes, or no times that can be compared
};
/// Returns "power law", "power law with logarithm", "apparent exponent", "undecided"
const char* to_string(Growth growth);

/// Holds how one quantity of one curve grows with n.
struct ScalingEntry {
  CurveKey key;
  Quantity quantity{};
  std::vector<SizeSample> all;        ///< everything measured, for plots
  std::vector<CensoredRow> censored;  ///< rows that ended before they had a value
  std::vector<SizeSample> used;       ///< what was fitted: choose_sizes
  CurveFit power;                     ///< n^a; a is the apparent exponent over the fitted sizes
  CurveFit with_log;                  ///< n^a log^b n
  Curvature curvature;                ///< how far from a power law the sizes are
  double log_weight = kMissing;       ///< ar3d::log_weight
  bool decided = false;               ///< the apparent exponent has an interval
  Growth growth = Growth::undecided;
  /// Says where a power law's exponent lies for larger n, too, if what is left of a lower-order
  /// term falls at least like n^(-1/2): power.exponent_interval widened by the drift at either end.
  Interval law_interval{kMissing, kMissing};
  std::string reason;  ///< why so, one sentence
  std::string next;    ///< which sizes and seeds would decide, in words; empty if nothing would
  std::vector<std::int64_t> next_sizes;  ///< n to add for that
};

/// ScalingEntry::reason of a drawing time that no row of the timing phase tells.
inline constexpr const char* kUntimed = "no rows of the timing phase";

/// Fits one sample. Cost: O(s^2) for s sizes.
ScalingEntry fit_scaling(std::vector<SizeSample> all, const FitOptions& options = {});

/// Returns every quantity that was measured in every curve, in the order of the file. Drawing times
/// are fitted where the curve has rows of the timing phase, and from these alone. Same numbers on
/// any thread count.
std::vector<ScalingEntry> scaling(const StudyTally& tally, const FitOptions& options = {});
std::vector<ScalingEntry> scaling(const Results& results, const FitOptions& options = {});

/// Returns the power of n in a theorem's bound on a quantity of the box; nothing for a drawing
/// time, and for one that promises no box.
std::optional<double> theorem_order(const SizeBound& theorem, Quantity quantity);

/// A quantity that a theorem bounds by c n^order grows no faster for ever: a power law whose whole
/// law_interval lies above is an apparent exponent (docs/analysis.md, Growth, point 5).
void refuse_law_above(double order, ScalingEntry& entry);

}  // namespace ar3d
