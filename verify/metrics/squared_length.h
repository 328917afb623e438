#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ar3d/model/lattice.h"
#include "ar3d/verify/metrics/functional.h"

namespace ar3d::verify {

/// d^T gram d, in a type in which no term wraps.
template <class Integer>
Integer squared_length(const Lattice& lattice, Vector d) {
  Integer sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum += Integer(component(d, i)) * Integer(lattice.gram[i][j]) * Integer(component(d, j));
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

}  // namespace ar3d::verify
