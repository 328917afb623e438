#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "ar3d/model/lattice.h"

// Do two closed segments meet? One formula for every type of number: integers of any width, in
// which it is exact if they hold all values (Lemma V.5 of docs/verify.md), and floating-point
// numbers, in which it rounds.

namespace ar3d::verify {

/// Says what two closed segments have in common.
enum class MeetingKind : std::uint8_t {
  nothing,
  touch,    ///< one point, and the segments are parallel
  cross,    ///< one point, and they are not
  overlap,  ///< more than one point
};

namespace meeting {

template <class Number>
using Triple = std::array<Number, 3>;

template <class Number>
Triple<Number> converted(Point p) {
  return {Number(p.x), Number(p.y), Number(p.z)};
}

template <class Number>
Triple<Number> difference(const Triple<Number>& a, const Triple<Number>& b) {
  return {Number(a[0] - b[0]), Number(a[1] - b[1]), Number(a[2] - b[2])};
}

template <class Number>
Triple<Number> cross(const Triple<Number>& u, const Triple<Number>& v) {
  return {Number(u[1] * v[2] - u[2] * v[1]), Number(u[2] * v[0] - u[0] * v[2]),
          Number(u[0] * v[1] - u[1] * v[0])};
}

template <class Number>
bool is_zero(const Triple<Number>& n) {
  return n[0] == 0 && n[1] == 0 && n[2] == 0;
}

template <class Number>
Number magnitude(const Number& value) {
  return value < 0 ? Number(-value) : value;
}

/// 0 <= numerator / denominator <= 1, for denominator != 0.
template <class Number>
bool in_unit_interval(const Number& numerator, const Number& denominator) {
  return denominator > 0 ? numerator >= 0 && numerator <= denominator
                         : numerator <= 0 && numerator >= denominator;
}

/// Collinear segments: their projections to the axis of u's longest component decide.
template <class Number>
MeetingKind on_line(const Triple<Number>& a, const Triple<Number>& b, const Triple<Number>& c,
                    const Triple<Number>& d, const Triple<Number>& u) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (magnitude(u[i]) > magnitude(u[axis])) axis = i;
  }
  const Number low = std::max(std::min(a[axis], b[axis]), std::min(c[axis], d[axis]));
  const Number high = std::min(std::max(a[axis], b[axis]), std::max(c[axis], d[axis]));
  if (high < low) return MeetingKind::nothing;
  return low == high ? MeetingKind::touch : MeetingKind::overlap;
}

/// Returns the kind of the meeting of converted points.
template <class Number>
MeetingKind kind(const Triple<Number>& a, const Triple<Number>& b, const Triple<Number>& c,
                 const Triple<Number>& d) {
  const Triple<Number> u = difference(b, a), v = difference(d, c), w = difference(c, a);
  const Triple<Number> n = cross(u, v);
  if (is_zero(n)) {
    return is_zero(cross(u, w)) ? on_line(a, b, c, d, u) : MeetingKind::nothing;
  }
  const Number triple = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
  if (triple != 0) return MeetingKind::nothing;
  // In their common plane a + s u = c + t v. Crossing w = s u - t v with v gives s n = w x v, with
  // u t n = w x u.
  const Triple<Number> s = cross(w, v), t = cross(w, u);
  std::size_t axis = 0;
  while (n[axis] == 0) ++axis;
  const bool meets = in_unit_interval(s[axis], n[axis]) && in_unit_interval(t[axis], n[axis]);
  return meets ? MeetingKind::cross : MeetingKind::nothing;
}

}  // namespace meeting

/// Returns what the segments from a to b and from c to d have in common, computed in `Number`.
/// @pre a != b and c != d, also as Numbers.
template <class Number>
MeetingKind meeting_kind(Point a, Point b, Point c, Point d) {
  using meeting::converted;
  return meeting::kind<Number>(converted<Number>(a), converted<Number>(b), converted<Number>(c),
                               converted<Number>(d));
}

}  // namespace ar3d::verify
