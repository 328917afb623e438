#pragma once

#include <cstdint>
#include <limits>

#include "ar3d/verify/checks/exact.h"

namespace ar3d::verify {

/// An integer linear function p -> f . p, by its coefficients. Key is a type in which no value
/// wraps.
template <class Key>
Key value(Vector f, Point p) {
  return Key{f.x} * Key{p.x} + Key{f.y} * Key{p.y} + Key{f.z} * Key{p.z};
}

/// True if int64 holds f . p for all points whose coordinates are at most `bound` in absolute
/// value.
inline bool fits_int64(Vector f, std::int64_t bound) {
  const auto magnitude = [](std::int64_t c) { return Int128{c < 0 ? -c : c}; };
  return (magnitude(f.x) + magnitude(f.y) + magnitude(f.z)) * bound <=
         std::numeric_limits<std::int64_t>::max();
}

inline std::int64_t component(Vector v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
inline std::int64_t component(Point p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// d x (unit vector of the axis): a functional that vanishes along d, with d's coefficients.
inline Vector times_unit(Vector d, std::size_t axis) {
  if (axis == 0) return {0, d.z, -d.y};
  if (axis == 1) return {-d.z, 0, d.x};
  return {d.y, -d.x, 0};
}

/// Some axis along which v is not zero, for v != 0.
inline std::size_t leading_axis(Vector v) { return v.x != 0 ? 0 : v.y != 0 ? 1 : 2; }

}  // namespace ar3d::verify
