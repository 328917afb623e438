#pragma once

#include <array>
#include <optional>

#include "ar3d/model/lattice.h"
#include "ar3d/verify/predicates/meeting.h"

namespace ar3d::verify {

__extension__ using Int128 = __int128;

/// u x v for components below 2^62 in absolute value: every component is below 2 * 2^124 = 2^125.
std::array<Int128, 3> cross(Vector u, Vector v);

bool parallel(Vector u, Vector v);

/// True if p lies on the closed segment from a to b (a != b).
bool on_segment(Point p, Point a, Point b);

/// Holds what two closed segments have in common.
struct Meeting {
  MeetingKind kind = MeetingKind::nothing;
  std::optional<Point> at;         ///< the common point, if it is a lattice point
  std::array<Point, 2> overlap{};  ///< the ends of the common part
};

/// Integers to decide in.
enum class IntegerWidth { int64, int128, int256 };
/// The narrowest that holds values below 2^bits in absolute value; int256 for all that are wider.
IntegerWidth width_of_bits(int bits);

/// meeting_kind() in integers of that width.
/// @pre width_of_bits() of predicate_bits().meeting is not wider; int256 serves all segments of
/// positive length whose ends are in range (coordinates at most 2^61 in absolute value): their
/// triple product is below 6 * 2^186 < 2^189.
MeetingKind meeting_kind_in(IntegerWidth width, Point a, Point b, Point c, Point d);

/// meeting_kind_in() with the common points. Parameters of the point are in __int128.
Meeting meet(Point a, Point b, Point c, Point d, IntegerWidth width = IntegerWidth::int256);

}  // namespace ar3d::verify
