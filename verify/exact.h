#pragma once

#include <array>
#include <optional>

#include "ar3d/model/lattice.h"

namespace ar3d::verify {

__extension__ using Int128 = __int128;

/// u x v for components below 2^62 in absolute value: every component is below 2 * 2^124 = 2^125.
std::array<Int128, 3> cross(Vector u, Vector v);

bool parallel(Vector u, Vector v);

/// True if p lies on the closed segment from a to b (a != b).
bool on_segment(Point p, Point a, Point b);

/// What two closed segments have in common.
struct Meeting {
  enum class Kind { nothing, point, overlap };
  Kind kind = Kind::nothing;
  std::optional<Point> at;         ///< the common point, if it is a lattice point
  std::array<Point, 2> overlap{};  ///< the ends of the common part
};

/// Exact for segments of positive length whose ends are in range (coordinates at most 2^61 in
/// absolute value). Widths: differences are below 2^62, their cross products and the segments'
/// parameters in __int128; the triple product that decides coplanarity is below 3 * 2^62 * 2^125 <
/// 2^189 and uses 256 bits.
Meeting meet(Point a, Point b, Point c, Point d);

}  // namespace ar3d::verify
