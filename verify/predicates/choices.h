#pragma once

#include <compare>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/model/lattice.h"
#include "ar3d/verify/predicates/meeting.h"

namespace ar3d::verify {

/// The predicates of a certificate in one arithmetic. The points are converted to its numbers
/// first, as geometric programs hold them.
struct PredicateChoice {
  static constexpr int kAlways = std::numeric_limits<int>::max();

  std::string name;  ///< "float", "double", kLongDouble (base/ieee_arithmetic.h), "cosine",
                     ///< "filtered", "int64", "int128", "int1024"
  /// Exact where predicate_bits() and the coordinates need at most so many bits; 0: never proved.
  int exact_bits = 0;
  /// The sign of cos(angle) - c at the point `at` between those towards `from` and `to`.
  std::strong_ordering (*angle)(const Lattice&, Point from, Point at, Point to, Cosine) = nullptr;
  MeetingKind (*meeting)(Point a, Point b, Point c, Point d) = nullptr;
};

/// float, double and long double: the formulas of compare_cosine() and meeting_kind(). cosine: the
/// textbook's <u,v> / (|u| |v|) against c in double, meetings as double. filtered: double, if a
/// bound of its error decides (filtered_angle, surely_skew), else exact. int64, int128: undefined where the range check does not
/// prove them. int1024: exact for all drawings.
const std::vector<PredicateChoice>& predicate_choices();
/// @throws InternalError if there is none of that name.
const PredicateChoice& predicate_choice(const std::string& name);

/// The filter of "filtered" alone: nothing where the error's bound does not decide. An angle that
/// is exactly arccos(c) is never decided.
std::optional<std::strong_ordering> filtered_angle(const Lattice& lattice, Point from, Point at,
                                                   Point to, Cosine c);

}  // namespace ar3d::verify
