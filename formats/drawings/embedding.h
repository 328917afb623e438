#pragma once

#include <array>
#include <cmath>

#include "ar3d/model/lattice.h"
#include "ar3d/model/vector3.h"

namespace ar3d {

using Real3 = Vector3<double>;
inline double length(Real3 a) { return std::sqrt(dot(a, a)); }

/// From lattice coordinates to space: squared Euclidean lengths there are the lattice's squared
/// lengths, so angles are true; z stays the vertical direction. On the cube lattice nothing
/// changes. Made of the Cholesky factor of gram / gram_denominator; rounded, for pictures and other
/// programs.
class Embedding {
 public:
  explicit Embedding(const Lattice& lattice) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = static_cast<double>(lattice.gram[i][j]) / lattice.gram_denominator;
        for (std::size_t k = 0; k < j; ++k) sum -= factor_[i][k] * factor_[j][k];
        factor_[i][j] = i == j ? std::sqrt(sum) : sum / factor_[j][j];
      }
    }
  }
  Real3 operator()(Vector d) const {
    const std::array<double, 3> u = {static_cast<double>(d.x), static_cast<double>(d.y),
                                     static_cast<double>(d.z)};
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) out[j] += factor_[i][j] * u[i];
    }
    return {out[0], out[1], out[2]};
  }
  Real3 operator()(Point p) const { return (*this)(p - Point{}); }

 private:
  std::array<std::array<double, 3>, 3> factor_{};
};

}  // namespace ar3d
