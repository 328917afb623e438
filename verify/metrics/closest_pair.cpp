// The smallest distance of two vertices by a grid of cubes, with vertices in random order.
// Distances are compared as integers whose width is proved.
#include "ar3d/verify/metrics/closest_pair.h"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/verify/predicates/exact.h"
#include "ar3d/verify/predicates/functional.h"

namespace ar3d::verify {
namespace {

// Differences are at most 2^62, Gram entries below 2^31: nine terms are below 2^(124 + 31 + 4) =
// 2^159.
using Wide = boost::multiprecision::checked_int256_t;

/// Points inserted one after the other into a grid whose cubes are about as large as the smallest
/// distance so far: a closer pair lies in neighbouring cubes, and a cube holds a bounded number of
/// points.
template <class Integer>
class ClosestPair {
 public:
  explicit ClosestPair(const Drawing& drawing)
      : drawing_(drawing),
        inverse_diagonal_(inverse_diagonal(drawing.lattice())),
        order_(drawing.num_vertices()),
        next_(order_.size()),
        heads_(std::bit_ceil(2 * order_.size())) {
    std::iota(order_.begin(), order_.end(), Vertex{0});
    // A random order makes rebuilding rare: after i points it happens with probability at most 2/i.
    RandomStream(0, kStream).shuffle(std::span<Vertex>(order_));
    best_ = {order_[0], order_[1]};
    smallest_ = distance(order_[0], order_[1]);
  }

  VertexPair run() {
    rebuild(0);
    for (std::size_t i = 0; i < order_.size() && smallest_ != 0; ++i) {
      if (improve(order_[i])) rebuild(i);
      insert(order_[i]);
    }
    return best_;
  }

 private:
  static constexpr std::uint64_t kStream = 0x636c6f73;
  static constexpr Vertex kEnd = std::numeric_limits<Vertex>::max();
  using Cube = std::array<std::int64_t, 3>;

  Integer distance(Vertex u, Vertex v) const {
    return squared_length<Integer>(drawing_.lattice(), drawing_.vertex(u) - drawing_.vertex(v));
  }

  Cube cube_of(Vertex v) const {
    const Point p = drawing_.vertex(v);
    Cube cube{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t c = component(p, i);
      cube[i] = c >= 0 ? c / side_[i] : -((-c - 1) / side_[i]) - 1;  // rounded down
    }
    return cube;
  }

  std::size_t bucket(const Cube& cube) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cube) {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return hash & (heads_.size() - 1);
  }

  /// Takes the pair of v and an inserted vertex as the best one if it is closer.
  bool improve(Vertex v) {
    const Cube cube = cube_of(v);
    bool improved = false;
    for (int k = 0; k < 27; ++k) {
      const Cube near{cube[0] + k % 3 - 1, cube[1] + k / 3 % 3 - 1, cube[2] + k / 9 - 1};
      // Different cubes may share a bucket: that costs time only.
      for (Vertex u = heads_[bucket(near)]; u != kEnd; u = next_[u]) {
        const Integer d = distance(u, v);
        if (d >= smallest_) continue;
        smallest_ = d;
        best_ = {u, v};
        improved = true;
      }
    }
    return improved;
  }

  void insert(Vertex v) {
    Vertex& head = heads_[bucket(cube_of(v))];
    next_[v] = head;
    head = v;
  }

  /// Cubes for the smallest distance so far, with the first `count` vertices in them.
  void rebuild(std::size_t count) {
    // Pairs at most so far apart are neighbours.
    for (std::size_t i = 0; i < 3; ++i) {
      side_[i] = reach(static_cast<double>(smallest_), inverse_diagonal_[i]);
    }
    std::fill(heads_.begin(), heads_.end(), kEnd);
    for (std::size_t i = 0; i < count; ++i) insert(order_[i]);
  }

  const Drawing& drawing_;
  std::array<double, 3> inverse_diagonal_;
  std::vector<Vertex> order_;
  std::vector<Vertex> next_;
  std::vector<Vertex> heads_;
  std::array<std::int64_t, 3> side_{1, 1, 1};
  VertexPair best_{};
  Integer smallest_ = 0;
};

/// Nine terms of differences below 2^42 and Gram entries below 2^31 stay below 2^(84 + 31 + 4) =
/// 2^119.
bool is_small(const Drawing& drawing) {
  constexpr std::int64_t kSmall = std::int64_t{1} << 41;
  for (std::size_t i = 0; i < drawing.num_vertices(); ++i) {
    const Point p = drawing.vertex(static_cast<Vertex>(i));
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) >= kSmall) return false;
  }
  return true;
}

}  // namespace

std::optional<VertexPair> closest_pair_by_grid(const Drawing& drawing) {
  if (drawing.num_vertices() < 2) return std::nullopt;
  drawing.lattice().validate();
  if (is_small(drawing)) return ClosestPair<Int128>(drawing).run();
  return ClosestPair<Wide>(drawing).run();
}

std::optional<VertexPair> closest_pair(const Drawing& drawing) {
  if (drawing.num_vertices() < 2) return std::nullopt;
  drawing.lattice().validate();
  if (const auto pair = closest_pair_by_strips(drawing)) return pair;
  return closest_pair_by_grid(drawing);
}

}  // namespace ar3d::verify
