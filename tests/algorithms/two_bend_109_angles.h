#pragma once

// Angles in the metric of two-bend-109, in double precision, and all stubs of Lemma E.3.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "ar3d/algorithms/two_bend_109/stubs.h"

namespace ar3d::two_bend_109 {

using Real3 = std::array<double, 3>;

inline double dot(Real3 a, Real3 b) { return 2 * a[0] * b[0] + 6 * a[1] * b[1] + a[2] * b[2]; }
inline Real3 real(Vector d) {
  return {static_cast<double>(d.x), static_cast<double>(d.y), static_cast<double>(d.z)};
}
inline Vector minus(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline constexpr double kDegree = std::numbers::pi / 180;
inline double angle(Real3 a, Real3 b) {
  return std::acos(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b))) / kDegree;
}
/// The horizontal direction at this angle from the x-axis.
inline Real3 at(double degrees) {
  return {std::cos(degrees * kDegree) / std::sqrt(2.0),
          std::sin(degrees * kDegree) / std::sqrt(6.0), 0};
}
inline constexpr Real3 kUp = {0, 0, 1};
inline constexpr Real3 kDown = {0, 0, -1};
inline const double kMostTurn = std::acos(1.0 / 3) / kDegree;

struct Sides {
  Stance stance;
  Real3 first;
  Real3 second;
  double slack;  ///< what Lemma E.4 needs, in degrees
};
inline const std::vector<Sides> kCycleStances = {{Stance::chain, at(0), at(180), 6.7},
                                                 {Stance::corner, at(0), at(90), 6.7},
                                                 {Stance::triangle_right, at(150), at(210), 6.8},
                                                 {Stance::triangle_upper, at(-30), at(-90), 6.8}};

inline std::vector<Stubs> all_stubs() {
  std::vector<Stubs> all = {stubs_of(Stance::middle, 0), stubs_of(Stance::three_down, 3)};
  for (const Sides& sides : kCycleStances) {
    for (const unsigned downs : {0u, 1u, 2u}) all.push_back(stubs_of(sides.stance, downs));
  }
  return all;
}

/// Of what leans by one part in `slope`, in degrees.
inline double lean(std::int64_t slope) {
  return std::atan(1.0 / static_cast<double>(slope)) / kDegree;
}

}  // namespace ar3d::two_bend_109
