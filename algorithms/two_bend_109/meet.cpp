// Step E.4: whether two segments meet, exactly: most pairs are decided by their boxes or modulo
// 2^64, the others take up to 256 bits. Cost: O(1).
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

#include "ar3d/algorithms/two_bend_109/drawn_segments.h"

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

/// Most vectors are seen not to be orthogonal modulo 2^64.
bool is_orthogonal(const Wide& n, Vector w) {
  const auto product = [](Int128 a, std::int64_t b) {
    return static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b);
  };
  if (product(n[0], w.x) + product(n[1], w.y) + product(n[2], w.z) != 0) return false;
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

bool are_parallel(Vector u, Vector v) { return is_zero(cross(u, v)); }

bool meet(const LatticeSegment& a, const LatticeSegment& b) {
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
