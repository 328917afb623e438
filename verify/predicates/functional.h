#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "ar3d/model/drawing.h"
#include "ar3d/verify/predicates/exact.h"

namespace ar3d::verify {

inline std::int64_t component(Vector v, std::size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
inline std::int64_t component(Point p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// The largest absolute value.
inline std::int64_t largest_coordinate(const Box& box) {
  std::int64_t largest = 0;
  for (const Point p : {box.low, box.high}) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return largest;
}

/// d x (unit vector of the axis): a functional that vanishes along d, with d's coefficients.
inline Vector times_unit(Vector d, std::size_t axis) {
  if (axis == 0) return {0, d.z, -d.y};
  if (axis == 1) return {-d.z, 0, d.x};
  return {d.y, -d.x, 0};
}

/// The primitive normal of a plane of two directions whose components are below 2^20: its own are
/// below 2^41.
inline Vector plane_normal(Vector a, Vector b) {
  const auto n = cross(a, b);
  return primitive({static_cast<std::int64_t>(n[0]), static_cast<std::int64_t>(n[1]),
                    static_cast<std::int64_t>(n[2])});
}

/// Some axis along which v is not zero, for v != 0.
inline std::size_t leading_axis(Vector v) { return v.x != 0 ? 0 : v.y != 0 ? 1 : 2; }

/// d^T gram d, in a type in which no term wraps.
template <class Integer>
Integer squared_length(const Lattice& lattice, Vector d) {
  const auto& g = lattice.gram;
  if (is_diagonal(lattice)) {
    const auto square = [](std::int64_t c) { return Integer(c) * Integer(c); };
    return square(d.x) * Integer(g[0][0]) + square(d.y) * Integer(g[1][1]) +
           square(d.z) * Integer(g[2][2]);
  }
  Integer sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum += Integer(component(d, i)) * Integer(g[i][j]) * Integer(component(d, j));
    }
  }
  return sum;
}

/// Diagonal of the inverse Gram matrix: |d_i|^2 <= d^T gram d * inverse_ii for every vector d.
inline std::array<double, 3> inverse_diagonal(const Lattice& lattice) {
  const auto g = [&](std::size_t i, std::size_t j) {
    return static_cast<long double>(lattice.gram[i % 3][j % 3]);
  };
  const auto cofactor = [&](std::size_t i) {
    return g(i + 1, i + 1) * g(i + 2, i + 2) - g(i + 1, i + 2) * g(i + 2, i + 1);
  };
  const long double determinant = g(0, 0) * cofactor(0) +
                                  g(0, 1) * (g(1, 2) * g(2, 0) - g(1, 0) * g(2, 2)) +
                                  g(0, 2) * (g(1, 0) * g(2, 1) - g(1, 1) * g(2, 0));
  std::array<double, 3> diagonal{};
  for (std::size_t i = 0; i < 3; ++i) diagonal[i] = static_cast<double>(cofactor(i) / determinant);
  return diagonal;
}

/// No vector d with d^T gram d <= squared has a larger component along the axis of this entry of
/// the inverse's diagonal; rounded up by more than the error of the floating-point terms.
inline std::int64_t reach(double squared, double inverse_entry) {
  const double reach = std::sqrt(squared * inverse_entry);
  return static_cast<std::int64_t>(std::min(reach * 1.000001, 0x1p61)) + 1;
}

inline std::array<double, 3> rounded(Vector v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// The points from + t * step, 0 <= t <= 1; a single one if step is zero.
struct SegmentInSpace {
  Point from;
  Vector step;
};

/// True only if no line contains both segments and no plane does: their triple product, computed
/// in double, is larger than all its rounding errors (Lemma V.9). @pre coordinates are in range.
inline bool surely_skew(const SegmentInSpace& a, const SegmentInSpace& b) {
  const auto u = rounded(a.step);
  const auto v = rounded(b.step);
  const auto w = rounded(b.from - a.from);
  double triple = 0;
  double sizes = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double one = u[j] * v[k];
    const double other = u[k] * v[j];
    triple += w[i] * (one - other);
    sizes += std::abs(w[i]) * (std::abs(one) + std::abs(other));
  }
  return std::abs(triple) > 0x1p-46 * sizes;
}

}  // namespace ar3d::verify
