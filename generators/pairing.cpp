#include "ar3d/generators/pairing.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ar3d {
namespace {

/// A pairing in the making: the pairs drawn so far as adjacency, `slots` places a vertex.
class PartialPairing {
 public:
  PartialPairing(Count num_vertices, std::uint32_t slots)
      : slots_(slots),
        slot_(num_vertices * slots),
        neighbour_(num_vertices * slots),
        degree_(num_vertices) {
    std::iota(slot_.begin(), slot_.end(), 0u);
  }

  /// Draws the pairs one after the other; false at the first loop or parallel edge. The slots are
  /// never put back in order: a Fisher-Yates shuffle gives a uniform sequence from any start.
  bool attempt(Count pairs, RandomStream& random) {
    for (std::size_t i = 0; i < 2 * pairs; i += 2) {
      const Vertex u = draw(i, random);
      const Vertex v = draw(i + 1, random);
      if (u == v || adjacent(u, v)) {
        forget(i);
        return false;
      }
      neighbour_[u * slots_ + degree_[u]++] = v;
      neighbour_[v * slots_ + degree_[v]++] = u;
    }
    return true;
  }

  std::vector<Edge> edges(Count pairs) && {
    slot_ = {};
    std::vector<Edge> edges;
    edges.reserve(pairs);
    for (Vertex u = 0; u < degree_.size(); ++u) {
      for (std::uint32_t i = 0; i < degree_[u]; ++i) {
        const Vertex v = neighbour_[u * slots_ + i];
        if (u < v) edges.push_back({u, v});
      }
    }
    return edges;
  }

 private:
  Vertex draw(std::size_t i, RandomStream& random) {
    const auto left = static_cast<std::uint32_t>(slot_.size() - i);
    std::swap(slot_[i], slot_[i + random.below(left)]);
    return static_cast<Vertex>(slot_[i] / slots_);
  }
  bool adjacent(Vertex u, Vertex v) const {
    const Vertex* const row = neighbour_.data() + u * slots_;
    return std::find(row, row + degree_[u], v) != row + degree_[u];
  }
  /// Undoes an attempt that has drawn its first `drawn` slots (and two more, which were not
  /// entered).
  void forget(std::size_t drawn) {
    for (std::size_t i = 0; i < drawn; ++i) degree_[slot_[i] / slots_] = 0;
  }

  std::size_t slots_;
  std::vector<std::uint32_t> slot_;  // the sequence of slots; slot s belongs to vertex s / slots_
  std::vector<Vertex> neighbour_;
  std::vector<std::uint8_t> degree_;
};

}  // namespace

std::vector<Edge> random_simple_pairs(Count num_vertices, std::uint32_t slots, Count pairs,
                                      RandomStream& random) {
  PartialPairing pairing(num_vertices, slots);
  while (!pairing.attempt(pairs, random)) {
  }
  return std::move(pairing).edges(pairs);
}

}  // namespace ar3d
