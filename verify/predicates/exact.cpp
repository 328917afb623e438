// Decides exactly how two segments meet, in the narrowest of three integers that is proved wide
// enough.
#include "ar3d/verify/predicates/exact.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdlib>

#include "ar3d/verify/predicates/functional.h"
#include "ar3d/verify/predicates/widths.h"

namespace ar3d::verify {
namespace {

using Int256 = boost::multiprecision::checked_int256_t;
using Normal = std::array<Int128, 3>;

Int128 greatest_common_divisor(Int128 a, Int128 b) {
  a = meeting::magnitude(a);
  b = meeting::magnitude(b);
  while (b != 0) {
    const Int128 rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

/// a + (numerator / denominator) u, for a parameter in [0, 1], if it is a lattice point.
std::optional<Point> lattice_point(Point a, Vector u, Int128 numerator, Int128 denominator) {
  const Int128 g = greatest_common_divisor(numerator, denominator);
  numerator /= g;
  denominator /= g;
  std::array<std::int64_t, 3> moved{};
  for (std::size_t i = 0; i < 3; ++i) {
    // Lowest terms: the product is an integer exactly if the denominator divides the step.
    const std::int64_t steps = component(u, i);
    if (steps % denominator != 0) return std::nullopt;
    moved[i] = static_cast<std::int64_t>(steps / denominator * numerator);
  }
  return a + Vector{moved[0], moved[1], moved[2]};
}

/// Collinear segments: their projections to the axis of u's longest component decide.
Meeting meet_on_line(Point a, Point b, Point c, Point d, Vector u) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(component(u, i)) > std::abs(component(u, axis))) axis = i;
  }
  const auto before = [&](Point p, Point q) { return component(p, axis) < component(q, axis); };
  const Point low = std::max(std::min(a, b, before), std::min(c, d, before), before);
  const Point high = std::min(std::max(a, b, before), std::max(c, d, before), before);
  if (before(high, low)) return {};
  if (low == high) return {MeetingKind::touch, low, {low, low}};
  return {MeetingKind::overlap, std::nullopt, {low, high}};
}

}  // namespace

std::array<Int128, 3> cross(Vector u, Vector v) {
  return meeting::cross<Int128>({u.x, u.y, u.z}, {v.x, v.y, v.z});
}

bool parallel(Vector u, Vector v) { return meeting::is_zero(cross(u, v)); }

bool on_segment(Point p, Point a, Point b) {
  const auto [px, py, pz] = p;
  if (px < std::min(a.x, b.x) || px > std::max(a.x, b.x)) return false;
  if (py < std::min(a.y, b.y) || py > std::max(a.y, b.y)) return false;
  if (pz < std::min(a.z, b.z) || pz > std::max(a.z, b.z)) return false;
  return parallel(p - a, b - a);
}

IntegerWidth width_of_bits(int bits) {
  if (bits <= kInt64Bits) return IntegerWidth::int64;
  return bits <= kInt128Bits ? IntegerWidth::int128 : IntegerWidth::int256;
}

MeetingKind meeting_kind_in(IntegerWidth width, Point a, Point b, Point c, Point d) {
  if (width == IntegerWidth::int64) return meeting_kind<std::int64_t>(a, b, c, d);
  if (width == IntegerWidth::int128) return meeting_kind<Int128>(a, b, c, d);
  return meeting_kind<Int256>(a, b, c, d);
}

Meeting meet(Point a, Point b, Point c, Point d, IntegerWidth width) {
  const MeetingKind kind = meeting_kind_in(width, a, b, c, d);
  if (kind == MeetingKind::nothing) return {};
  const Vector u = b - a;
  if (kind != MeetingKind::cross) return meet_on_line(a, b, c, d, u);
  // a + s u = c + t v: crossing w = s u - t v with v gives s u x v = w x v.
  const Vector v = d - c;
  const Normal n = cross(u, v);
  const Normal s = cross(c - a, v);
  std::size_t axis = 0;
  while (n[axis] == 0) ++axis;
  return {MeetingKind::cross, lattice_point(a, u, s[axis], n[axis]), {}};
}

}  // namespace ar3d::verify
