#pragma once

// Lattice points as four integers x0 .. x3 of sum 0. The direction ij is e_i - e_j; it is parallel
// to a face diagonal in the drawing. A line along ij keeps the other two coordinates.

#include <array>
#include <cstdint>

#include "ar3d/model/lattice.h"

namespace ar3d::compact_120 {

/// Most vertices of a drawing. Widths: the widest strip has at most 36.14 sqrt(n) +
/// 801 columns and 0.54 sqrt(n) + 1 rows (docs/compact-120.md), so that for n <= 2^27 all
/// coordinates of vertices and bends, and sums of two, are below 2^24.
inline constexpr std::uint32_t kMaxVertices = std::uint32_t{1} << 27;

/// (x0, x1, x2, x3), of sum 0.
using Quad = std::array<std::int32_t, 4>;

/// The class of a vertex: S if it has degree 3 and all neighbours to the right, T if it has degree
/// 3 and all to the left, else N.
enum class Class : std::uint8_t { n = 0, s = 1, t = 2 };

/// The three directions in which edges leave any vertex: 01, 12, 20.
enum Arm : std::uint8_t { k01 = 0, k12 = 1, k20 = 2 };
inline constexpr std::array<Arm, 3> kArms = {k01, k12, k20};

/// Says where an edge arrives at its head: the arm, and on 12 whether the head has class N.
enum class Arrival : std::uint8_t { on_01 = 0, on_12 = 1, on_20 = 2, on_12_of_extreme = 3 };
inline Arrival arrival_on(Arm arm, Class head) {
  return arm == k12 && head != Class::n ? Arrival::on_12_of_extreme : static_cast<Arrival>(arm);
}

/// A place in the strip: a cell, which has one place for each class.
struct Site {
  std::int32_t column = -1;
  std::int32_t row = 0;
  Class of = Class::n;
  bool is_set() const { return column >= 0; }
  friend bool operator==(const Site&, const Site&) = default;
};

/// t and w of a site. Modulo 4 they are (0, 0) for N, (2, 2) for S, (2, 0) for T; the slant of a
/// vertex, w + 5t/2, is 4 row + 2 (column mod 2) - 1, 0 or 1, so that a strip is level.
inline std::int32_t t_of(Site s) { return 4 * s.column + (s.of == Class::n ? 0 : 2); }
inline std::int32_t w_of(Site s) {
  static constexpr std::array<std::int32_t, 3> kAlong = {0, -6, -4};
  return 4 * (s.row - 5 * s.column / 2) + kAlong[static_cast<std::size_t>(s.of)];
}

/// The slant w + 5t/2 of a site: an integer, as t is even.
inline std::int32_t slant(Site s) {
  return 4 * s.row + 2 * (s.column & 1) + (s.of == Class::t ? 1 : 0) - (s.of == Class::s ? 1 : 0);
}

/// The vertex at a site: (t, w, -5t - w, 4t), in the plane 5 x0 + x1 + x2 = 0.
inline Quad quad_of(Site s) {
  const std::int32_t t = t_of(s), w = w_of(s);
  return {t, w, -5 * t - w, 4 * t};
}

/// 5 x0 + x1 + x2: 0 at vertices, at least -4 on edges to the right, at most 4 on those to the
/// left.
inline std::int32_t height(const Quad& x) { return 5 * x[0] + x[1] + x[2]; }

/// The mirror image: it exchanges left and right, the arms 01 and 20, the classes S and T.
inline Quad mirrored(const Quad& x) { return {-x[0], -x[2], -x[1], -x[3]}; }
inline Arrival mirrored(Arrival at) {
  return at == Arrival::on_01 ? Arrival::on_20 : at == Arrival::on_20 ? Arrival::on_01 : at;
}

inline Point to_point(const Quad& x) {
  return {std::int64_t{x[0]} + x[1], std::int64_t{x[0]} + x[2], std::int64_t{x[1]} + x[2]};
}

/// The site of a vertex at a point that to_point(quad_of(site)) gave.
inline Site site_of(Point p) {
  const auto t = static_cast<std::int32_t>(-p.z / 5);
  const auto w = static_cast<std::int32_t>(p.x) - t;
  const Class of = t % 4 == 0 ? Class::n : (w & 3) == 2 ? Class::s : Class::t;
  const Site first{t / 4, 0, of};
  return {first.column, (w - w_of(first)) / 4, of};
}

}  // namespace ar3d::compact_120
