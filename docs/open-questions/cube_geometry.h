#pragma once

// Integer vectors, turned tetrahedra and segments on the cube grid, and random numbers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

namespace cube {

using Int = std::int64_t;
using V = std::array<Int, 3>;

inline V operator+(V a, V b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline V operator-(V a, V b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline V operator*(Int s, V a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Int dot(V a, V b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline V cross(V a, V b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// SplitMix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  Int in(Int low, Int high) {
    return low + static_cast<Int>(next() % std::uint64_t(high - low + 1));
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

using Tetrahedron = std::array<V, 4>;

/// The cube's diagonals turned by the quaternion a + bi + cj + dk, each as short as it can be.
inline Tetrahedron turned(Int a, Int b, Int c, Int d) {
  const std::array<V, 3> column = {
      V{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
      V{2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
      V{2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d}};
  constexpr std::array<V, 4> kDiagonals = {V{1, 1, 1}, V{1, -1, -1}, V{-1, 1, -1}, V{-1, -1, 1}};
  Tetrahedron result;
  for (std::size_t i = 0; i < 4; ++i) {
    const V& s = kDiagonals[i];
    const V v = (s[0] * column[0]) + (s[1] * column[1]) + (s[2] * column[2]);
    const Int divisor = std::gcd(std::gcd(v[0], v[1]), v[2]);
    result[i] = {v[0] / divisor, v[1] / divisor, v[2] / divisor};
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline std::vector<Tetrahedron> tetrahedra(Int most) {
  std::set<Tetrahedron> found;
  const Int r = static_cast<Int>(std::sqrt(static_cast<double>(most)));
  for (Int a = -r; a <= r; ++a) {
    for (Int b = -r; b <= r; ++b) {
      for (Int c = -r; c <= r; ++c) {
        for (Int d = -r; d <= r; ++d) {
          const Int norm = a * a + b * b + c * c + d * d;
          if (norm != 0 && norm <= most) found.insert(turned(a, b, c, d));
        }
      }
    }
  }
  return {found.begin(), found.end()};
}

/// A tetrahedron near another one: which of its vectors stands for which.
struct NearTurn {
  double nearness;
  std::size_t to;
  std::array<std::uint8_t, 4> image;
};

inline NearTurn turn_to(const Tetrahedron& from, const Tetrahedron& to, std::size_t index) {
  NearTurn best{-4, index, {}};
  std::array<std::uint8_t, 4> order = {0, 1, 2, 3};
  do {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const V &u = from[k], &v = to[order[k]];
      sum += double(dot(u, v)) / std::sqrt(double(dot(u, u)) * double(dot(v, v)));
    }
    if (sum > best.nearness) best = {sum, index, order};
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

/// The up to 12 nearest to each.
inline std::vector<std::vector<NearTurn>> near_turns(const std::vector<Tetrahedron>& all) {
  std::vector<std::vector<NearTurn>> found(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (i != j) found[i].push_back(turn_to(all[i], all[j], j));
    }
    std::stable_sort(found[i].begin(), found[i].end(),
                     [](const NearTurn& a, const NearTurn& b) { return a.nearness > b.nearness; });
    if (found[i].size() > 12) found[i].resize(12);
  }
  return found;
}

/// Whether two segments have a point in common.
inline bool meet(const V& a, const V& b, const V& c, const V& d) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::max(a[k], b[k]) < std::min(c[k], d[k])) return false;
    if (std::max(c[k], d[k]) < std::min(a[k], b[k])) return false;
  }
  const V u = b - a, v = d - c, w = c - a;
  const V normal = cross(u, v);
  if (normal == V{}) return cross(u, w) == V{};
  if (dot(normal, w) != 0) return false;
  const Int whole = dot(normal, normal);
  const Int s = dot(cross(w, v), normal), t = dot(cross(w, u), normal);
  return 0 <= s && s <= whole && 0 <= t && t <= whole;
}

}  // namespace cube
