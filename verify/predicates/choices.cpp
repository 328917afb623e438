// The predicates of a certificate in several arithmetics, so that their speed and their errors can
// be measured. The filter's error bounds are proved where they stand.
#include "ar3d/verify/predicates/choices.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdlib>

#include "ar3d/base/error.h"
#include "ar3d/base/ieee_arithmetic.h"
#include "ar3d/model/cosine_comparison.h"
#include "ar3d/verify/predicates/exact.h"
#include "ar3d/verify/predicates/functional.h"
#include "ar3d/verify/predicates/widths.h"

namespace ar3d::verify {
namespace {

using Int1024 = boost::multiprecision::checked_int1024_t;
using meeting::Triple;

/// Two points as seen from a third one.
template <class Number>
std::array<Triple<Number>, 2> directions(Point from, Point at, Point to) {
  const Triple<Number> middle = meeting::converted<Number>(at);
  return {meeting::difference(meeting::converted<Number>(from), middle),
          meeting::difference(meeting::converted<Number>(to), middle)};
}

template <class Number>
std::strong_ordering angle_in(const Lattice& lattice, Point from, Point at, Point to, Cosine c) {
  const auto [u, v] = directions<Number>(from, at, to);
  return cosine_comparison::compare<Number>(lattice, u, v, c);
}

std::strong_ordering textbook_angle(const Lattice& lattice, Point from, Point at, Point to,
                                    Cosine c) {
  using cosine_comparison::inner;
  const auto [u, v] = directions<double>(from, at, to);
  const double cosine =
      inner(lattice, u, v) / (std::sqrt(inner(lattice, u, u)) * std::sqrt(inner(lattice, v, v)));
  const double wanted = static_cast<double>(c.numerator) / c.denominator;
  return cosine < wanted   ? std::strong_ordering::less
         : cosine > wanted ? std::strong_ordering::greater
                           : std::strong_ordering::equal;
}

bool is_exact_double(Point p) {
  constexpr std::int64_t kLimit = std::int64_t{1} << (kDoubleBits - 1);  // so are differences
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kLimit;
}

/// The sum of |u_i gram_ij v_j|: what the roundings of an inner product are relative to.
double size_of_terms(const Lattice& lattice, const Triple<double>& u, const Triple<double>& v) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum += std::abs(u[i]) * std::abs(double{1} * lattice.gram[i][j]) * std::abs(v[j]);
    }
  }
  return sum;
}

std::strong_ordering filtered_or_exact_angle(const Lattice& lattice, Point from, Point at, Point to,
                                             Cosine c) {
  const auto decided = filtered_angle(lattice, from, at, to, c);
  return decided ? *decided : compare_cosine(lattice, from - at, to - at, c);
}

MeetingKind exact_meeting(Point a, Point b, Point c, Point d) {
  return meeting_kind<boost::multiprecision::checked_int256_t>(a, b, c, d);
}

MeetingKind filtered_or_exact_meeting(Point a, Point b, Point c, Point d) {
  return surely_skew({a, b - a}, {c, d - c}) ? MeetingKind::nothing : exact_meeting(a, b, c, d);
}

}  // namespace

/// Differences of exact doubles below 2^53 are exact. An inner product of up to 9 terms is off by
/// at most 12 * 2^-53 of the sum T of its terms' sizes, so below 2^-49 T; squares and products of
/// two of them, times the cosine's squares, by less than 2^-47 of T^2, and of U V.
std::optional<std::strong_ordering> filtered_angle(const Lattice& lattice, Point from, Point at,
                                                   Point to, Cosine c) {
  if (!is_exact_double(from) || !is_exact_double(at) || !is_exact_double(to)) return std::nullopt;
  using cosine_comparison::inner;
  const auto [u, v] = directions<double>(from, at, to);
  const double p = inner(lattice, u, v);
  const double terms = size_of_terms(lattice, u, v);
  if (std::abs(p) <= 0x1p-48 * terms) return std::nullopt;
  const double squares_u = size_of_terms(lattice, u, u), squares_v = size_of_terms(lattice, v, v);
  const int wanted = cosine_comparison::sign(c.numerator);
  const int found = cosine_comparison::sign(p);
  if (found != wanted) return found <=> wanted;
  const double down = static_cast<double>(c.denominator) * c.denominator;
  const double up = static_cast<double>(c.numerator) * c.numerator;
  const double left = p * p * down;
  const double right = inner(lattice, u, u) * inner(lattice, v, v) * up;
  const double error = 0x1p-46 * (terms * terms * down + squares_u * squares_v * up);
  if (std::abs(left - right) <= error) return std::nullopt;
  const auto order = left < right ? std::strong_ordering::less : std::strong_ordering::greater;
  return found >= 0 ? order : 0 <=> order;
}

const std::vector<PredicateChoice>& predicate_choices() {
  static const std::vector<PredicateChoice> choices{
      {"float", std::numeric_limits<float>::digits, angle_in<float>, meeting_kind<float>},
      {"double", kDoubleBits, angle_in<double>, meeting_kind<double>},
      {kLongDouble, std::numeric_limits<long double>::digits, angle_in<long double>,
       meeting_kind<long double>},
      {"cosine", 0, textbook_angle, meeting_kind<double>},
      {"filtered", PredicateChoice::kAlways, filtered_or_exact_angle, filtered_or_exact_meeting},
      {"int64", kInt64Bits, angle_in<std::int64_t>, meeting_kind<std::int64_t>},
      {"int128", kInt128Bits, angle_in<Int128>, meeting_kind<Int128>},
      {"int1024", PredicateChoice::kAlways, angle_in<Int1024>, meeting_kind<Int1024>}};
  return choices;
}

const PredicateChoice& predicate_choice(const std::string& name) {
  for (const PredicateChoice& choice : predicate_choices()) {
    if (choice.name == name) return choice;
  }
  throw InternalError("no predicates in " + name);
}

}  // namespace ar3d::verify
