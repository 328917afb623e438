#include "ar3d/verify/exact.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>

namespace ar3d::verify {
namespace {

using Wide = boost::multiprecision::checked_int256_t;
using Normal = std::array<Int128, 3>;

std::array<std::int64_t, 3> components(Vector v) { return {v.x, v.y, v.z}; }
std::array<std::int64_t, 3> components(Point p) { return {p.x, p.y, p.z}; }

bool is_zero(const Normal& n) { return n[0] == 0 && n[1] == 0 && n[2] == 0; }

Int128 magnitude(Int128 v) { return v < 0 ? -v : v; }

bool below(Int128 v, int bits) { return magnitude(v) < Int128{1} << bits; }

/// w . n == 0.
bool orthogonal(Vector w, const Normal& n) {
  const auto d = components(w);
  const bool small = below(d[0], 40) && below(d[1], 40) && below(d[2], 40) && below(n[0], 84) &&
                     below(n[1], 84) && below(n[2], 84);
  if (small) return d[0] * n[0] + d[1] * n[1] + d[2] * n[2] == 0;  // below 3 * 2^124
  Wide sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += Wide(d[i]) * Wide(n[i]);
  return sum == 0;
}

/// 0 <= numerator / denominator <= 1, for denominator != 0.
bool in_unit_interval(Int128 numerator, Int128 denominator) {
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  return numerator >= 0 && numerator <= denominator;
}

Int128 greatest_common_divisor(Int128 a, Int128 b) {
  a = magnitude(a);
  b = magnitude(b);
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
  const auto steps = components(u);
  std::array<std::int64_t, 3> moved{};
  for (std::size_t i = 0; i < 3; ++i) {
    // Lowest terms: the product is an integer exactly if the denominator divides the step.
    if (steps[i] % denominator != 0) return std::nullopt;
    moved[i] = static_cast<std::int64_t>(steps[i] / denominator * numerator);
  }
  return a + Vector{moved[0], moved[1], moved[2]};
}

/// Collinear segments: their projections to the axis of u's longest component decide.
Meeting meet_on_line(Point a, Point b, Point c, Point d, Vector u) {
  const auto length = components(u);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (magnitude(length[i]) > magnitude(length[axis])) axis = i;
  }
  const auto before = [&](Point p, Point q) { return components(p)[axis] < components(q)[axis]; };
  const Point low = std::max(std::min(a, b, before), std::min(c, d, before), before);
  const Point high = std::min(std::max(a, b, before), std::max(c, d, before), before);
  if (before(high, low)) return {};
  if (low == high) return {Meeting::Kind::point, low, {low, low}};
  return {Meeting::Kind::overlap, std::nullopt, {low, high}};
}

}  // namespace

std::array<Int128, 3> cross(Vector u, Vector v) {
  return {Int128{u.y} * v.z - Int128{u.z} * v.y, Int128{u.z} * v.x - Int128{u.x} * v.z,
          Int128{u.x} * v.y - Int128{u.y} * v.x};
}

bool parallel(Vector u, Vector v) { return is_zero(cross(u, v)); }

bool on_segment(Point p, Point a, Point b) {
  const auto [px, py, pz] = p;
  if (px < std::min(a.x, b.x) || px > std::max(a.x, b.x)) return false;
  if (py < std::min(a.y, b.y) || py > std::max(a.y, b.y)) return false;
  if (pz < std::min(a.z, b.z) || pz > std::max(a.z, b.z)) return false;
  return parallel(p - a, b - a);
}

Meeting meet(Point a, Point b, Point c, Point d) {
  const Vector u = b - a;
  const Vector v = d - c;
  const Vector w = c - a;
  const Normal n = cross(u, v);
  if (is_zero(n)) return parallel(u, w) ? meet_on_line(a, b, c, d, u) : Meeting{};
  if (!orthogonal(w, n)) return {};
  // In their common plane a + s u = c + t v. Crossing w = s u - t v with v gives s n = w x v, with
  // u t n = w x u.
  const Normal s = cross(w, v);
  const Normal t = cross(w, u);
  std::size_t axis = 0;
  while (n[axis] == 0) ++axis;
  if (!in_unit_interval(s[axis], n[axis]) || !in_unit_interval(t[axis], n[axis])) return {};
  return {Meeting::Kind::point, lattice_point(a, u, s[axis], n[axis]), {}};
}

}  // namespace ar3d::verify
