#include "ar3d/generators/pairing.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ar3d {
namespace {

/// A pairing in the making: the pairs drawn so far as adjacency, `d` places per vertex.
class PartialPairing {
 public:
  PartialPairing(Count num_vertices, std::uint32_t d)
      : d_(d), point_(num_vertices * d), neighbour_(num_vertices * d), degree_(num_vertices) {
    std::iota(point_.begin(), point_.end(), 0u);
  }

  /// Draws the pairs one after the other; false at the first loop or parallel edge. The points are
  /// never put back in order: a Fisher-Yates shuffle gives a uniform sequence from any start.
  bool attempt(Count pairs, RandomStream& random) {
    for (std::size_t i = 0; i < 2 * pairs; i += 2) {
      const Vertex u = draw(i, random);
      const Vertex v = draw(i + 1, random);
      if (u == v || adjacent(u, v)) {
        forget(i);
        return false;
      }
      neighbour_[u * d_ + degree_[u]++] = v;
      neighbour_[v * d_ + degree_[v]++] = u;
    }
    return true;
  }

  std::vector<Edge> edges(Count pairs) && {
    point_ = {};
    std::vector<Edge> edges;
    edges.reserve(pairs);
    for (Vertex u = 0; u < degree_.size(); ++u) {
      for (std::uint32_t i = 0; i < degree_[u]; ++i) {
        const Vertex v = neighbour_[u * d_ + i];
        if (u < v) edges.push_back({u, v});
      }
    }
    return edges;
  }

 private:
  Vertex draw(std::size_t i, RandomStream& random) {
    const auto left = static_cast<std::uint32_t>(point_.size() - i);
    std::swap(point_[i], point_[i + random.below(left)]);
    return static_cast<Vertex>(point_[i] / d_);
  }
  bool adjacent(Vertex u, Vertex v) const {
    const Vertex* const row = neighbour_.data() + u * d_;
    return std::find(row, row + degree_[u], v) != row + degree_[u];
  }
  /// Undoes an attempt that has drawn its first `drawn` points (and two more, which were not
  /// entered).
  void forget(std::size_t drawn) {
    for (std::size_t i = 0; i < drawn; ++i) degree_[point_[i] / d_] = 0;
  }

  std::size_t d_;
  std::vector<std::uint32_t> point_;  // the sequence of points; point p belongs to vertex p / d_
  std::vector<Vertex> neighbour_;
  std::vector<std::uint8_t> degree_;
};

}  // namespace

std::vector<Edge> random_simple_pairs(Count num_vertices, std::uint32_t d, Count pairs,
                                      RandomStream& random) {
  PartialPairing pairing(num_vertices, d);
  while (!pairing.attempt(pairs, random)) {
  }
  return std::move(pairing).edges(pairs);
}

}  // namespace ar3d
