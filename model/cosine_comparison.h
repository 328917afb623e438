#pragma once

#include <array>
#include <compare>

#include "ar3d/model/lattice.h"

// compare_cosine() as one formula for every type of number: integers of any width, in which it is
// exact if they hold all values, and floating-point numbers, in which it rounds.

namespace ar3d::cosine_comparison {

template <class Number>
std::array<Number, 3> converted(Vector v) {
  return {Number(v.x), Number(v.y), Number(v.z)};
}

/// u^T gram v. No term and no partial sum passes the sum of all |u_i gram_ij v_j|.
template <class Number>
Number inner(const Lattice& lattice, const std::array<Number, 3>& u,
             const std::array<Number, 3>& v) {
  const auto& g = lattice.gram;
  Number sum = u[0] * Number(g[0][0]) * v[0];
  sum += u[1] * Number(g[1][1]) * v[1];
  sum += u[2] * Number(g[2][2]) * v[2];
  if (is_diagonal(lattice)) return sum;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (i != j && g[i][j] != 0) sum += u[i] * Number(g[i][j]) * v[j];
    }
  }
  return sum;
}

template <class Number>
int sign(const Number& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Compares p / sqrt(uu vv) with numerator / denominator by signs, then by squares: the sign of
/// cos(angle) - c, from p = <u,v>, uu = <u,u>, vv = <v,v>.
template <class Number>
std::strong_ordering compare(const Number& p, const Number& uu, const Number& vv, Cosine c) {
  const int cosine_sign = sign(p);
  const int wanted_sign = sign(c.numerator);
  if (cosine_sign != wanted_sign) return cosine_sign <=> wanted_sign;
  const Number left = p * p * Number(c.denominator) * Number(c.denominator);
  const Number right = uu * vv * Number(c.numerator) * Number(c.numerator);
  const auto squares = left < right   ? std::strong_ordering::less
                       : left > right ? std::strong_ordering::greater
                                      : std::strong_ordering::equal;
  return cosine_sign >= 0 ? squares : 0 <=> squares;
}

template <class Number>
std::strong_ordering compare(const Lattice& lattice, const std::array<Number, 3>& u,
                             const std::array<Number, 3>& v, Cosine c) {
  return compare<Number>(inner(lattice, u, v), inner(lattice, u, u), inner(lattice, v, v), c);
}

}  // namespace ar3d::cosine_comparison
