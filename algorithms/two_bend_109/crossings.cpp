// Whether two segments meet, for Step E.4: exactly, in 128-bit integers, and in 256 bits where
// those might not do. Boxes that do not overlap settle most pairs that come here. Cost: O(1).
#include "ar3d/algorithms/two_bend_109/crossings.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

namespace ar3d::two_bend_109 {
namespace {

__extension__ using Int128 = __int128;
using Int256 = boost::multiprecision::int256_t;

using Wide = std::array<Int128, 3>;

/// Components below 2^62: each product is below 2^124.
Wide cross(Vector u, Vector v) {
  const auto product = [](std::int64_t a, std::int64_t b) { return Int128{a} * b; };
  return {product(u.y, v.z) - product(u.z, v.y), product(u.z, v.x) - product(u.x, v.z),
          product(u.x, v.y) - product(u.y, v.x)};
}

bool is_zero(const Wide& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

bool is_orthogonal(const Wide& n, Vector w) {
  const double largest =
      std::max({std::abs(static_cast<double>(n[0])), std::abs(static_cast<double>(n[1])),
                std::abs(static_cast<double>(n[2]))}) *
      static_cast<double>(std::max({std::abs(w.x), std::abs(w.y), std::abs(w.z)}));
  if (largest < 0x1p124) return n[0] * w.x + n[1] * w.y + n[2] * w.z == 0;
  return Int256(n[0]) * w.x + Int256(n[1]) * w.y + Int256(n[2]) * w.z == 0;
}

bool overlap(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  return std::max(std::min(a, b), std::min(c, d)) <= std::min(std::max(a, b), std::max(c, d));
}

/// 0 <= part / whole <= 1.
bool is_fraction(Int128 part, Int128 whole) {
  if (whole < 0) {
    part = -part;
    whole = -whole;
  }
  return 0 <= part && part <= whole;
}

}  // namespace

bool meet(const Segment& a, const Segment& b) {
  if (!overlap(a.from.x, a.to.x, b.from.x, b.to.x) ||
      !overlap(a.from.y, a.to.y, b.from.y, b.to.y) ||
      !overlap(a.from.z, a.to.z, b.from.z, b.to.z)) {
    return false;
  }
  const Vector u = a.to - a.from;
  const Vector v = b.to - b.from;
  const Vector w = b.from - a.from;
  const Wide normal = cross(u, v);
  // On one line, boxes that overlap are segments that overlap.
  if (is_zero(normal)) return is_zero(cross(u, w));
  if (!is_orthogonal(normal, w)) return false;
  // a.from + s u = b.from + t v with s = (w x v) / (u x v), t = (w x u) / (u x v).
  const std::size_t k = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  return is_fraction(cross(w, v)[k], normal[k]) && is_fraction(cross(w, u)[k], normal[k]);
}

}  // namespace ar3d::two_bend_109
