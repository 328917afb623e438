#pragma once

#include <array>
#include <cmath>

namespace ar3d::precision {

/// The real types whose misses are predicted, in the order of two_bend_paper::RealType.
struct MeasuredType {
  const char* name;
  int bits;  ///< of the significand
};
inline constexpr std::array<MeasuredType, 3> kMeasuredTypes = {
    {{"float", 24}, {"double", 53}, {"long double", 64}}};

/// A miss is kappa 2^-p C radians. Over one graph of each family half of all kappas are above the
/// first, nine in ten below the second; docs/precision.md has those of several graphs.
inline constexpr double kMedianKappa = 0.15, kHighKappa = 0.53;
inline constexpr double kDegrees = 57.29577951308232;  ///< in a radian

/// Degrees. @param condition  RealAssessment::condition. @param bits  of the significand.
inline double predicted_miss(double condition, int bits, double kappa) {
  return kappa * kDegrees * std::ldexp(condition, -bits);
}

}  // namespace ar3d::precision
