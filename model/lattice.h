#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <string>

namespace ar3d {

/// Largest absolute value of a coordinate in a Drawing: differences and sums of two coordinates fit
/// 63 bits.
inline constexpr std::int64_t kMaxCoordinate = std::int64_t{1} << 61;

/// A lattice point (a position).
struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;
  friend auto operator<=>(const Point&, const Point&) = default;
};

/// A difference of lattice points. Components of differences of points are below 2^62 in absolute
/// value.
struct Vector {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;
  friend auto operator<=>(const Vector&, const Vector&) = default;
};

/// For tables of points.
struct PointHash {
  std::size_t operator()(const Point& p) const {
    std::uint64_t h = 0;
    for (const std::int64_t c : {p.x, p.y, p.z}) {
      h = (h ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return h;
  }
};

inline Vector operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator+(Point p, Vector d) { return {p.x + d.x, p.y + d.y, p.z + d.z}; }
inline Vector operator-(Vector d) { return {-d.x, -d.y, -d.z}; }
inline Vector operator*(std::int64_t k, Vector d) { return {k * d.x, k * d.y, k * d.z}; }

/// "(x, y, z)" for messages.
std::string to_string(Point p);
std::string to_string(Vector d);

/// True if every coordinate lies in [-kMaxCoordinate, kMaxCoordinate].
inline bool in_range(Point p) {
  const auto fits = [](std::int64_t c) { return c >= -kMaxCoordinate && c <= kMaxCoordinate; };
  return fits(p.x) && fits(p.y) && fits(p.z);
}

/// d divided by the greatest common divisor of its components; the zero vector stays.
Vector primitive(Vector d);

/// The cosine of an angle as an exact fraction; denominator > 0.
/// Angles of the paper: arccos(-1/3) = 109.47 degrees, arccos(-1/2) = 120 degrees.
struct Cosine {
  std::int32_t numerator = 0;
  std::int32_t denominator = 1;
  friend bool operator==(const Cosine&, const Cosine&) = default;
};

/// The metric of a drawing's coordinates: the squared length of an integer vector u is
/// (u^T gram u) / gram_denominator. gram is symmetric and positive definite.
struct Lattice {
  std::array<std::array<std::int32_t, 3>, 3> gram{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::int32_t gram_denominator = 1;
  friend bool operator==(const Lattice&, const Lattice&) = default;

  /// @throws InputError if gram is not symmetric and positive definite or the denominator not
  /// positive.
  void validate() const;
};

/// The unit cube grid, and the lattice of Theorem 2 with squared length x^2 + y^2 + z^2/3.
inline constexpr Lattice kCubeLattice{};
inline constexpr Lattice kScaledZLattice{{{{3, 0, 0}, {0, 3, 0}, {0, 0, 1}}}, 3};

/// Exact sign of cos(angle(u, v)) - c for non-zero vectors u, v with components below 2^62 in
/// absolute value. `equal` means the angle is exactly arccos(c); `less` means the angle is larger.
/// Widths: components below 2^20 with small Gram entries use __int128; everything else 1024-bit
/// integers (a squared inner product is below 2^((62 + 31 + 62 + 4) * 2) = 2^318, times c's squared
/// terms below 2^380).
std::strong_ordering compare_cosine(const Lattice& lattice, Vector u, Vector v, Cosine c);

/// Is the Gram matrix diagonal, the axes at right angles?
inline bool is_diagonal(const Lattice& lattice) {
  const auto& g = lattice.gram;
  return (g[0][1] | g[0][2] | g[1][0] | g[1][2] | g[2][0] | g[2][1]) == 0;
}

/// u^T gram u, rounded.
double approximate_square(const Lattice& lattice, Vector u);

/// Length of u in the metric of the lattice, rounded (for statistics, never for decisions).
inline double approximate_length(const Lattice& lattice, Vector u) {
  const auto& g = lattice.gram;
  const auto x = static_cast<double>(u.x), y = static_cast<double>(u.y),
             z = static_cast<double>(u.z);
  const double square = is_diagonal(lattice) ? x * g[0][0] * x + y * g[1][1] * y + z * g[2][2] * z
                                             : approximate_square(lattice, u);
  if (lattice.gram_denominator == 1) return std::sqrt(square);
  return std::sqrt(square / lattice.gram_denominator);
}

}  // namespace ar3d
