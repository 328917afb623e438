// Automorphisms of a small graph by trying: images are chosen vertex by vertex, each beside the
// image of an earlier neighbour, so that few are to be tried.
#include "ar3d/optimum/automorphisms.h"

#include <algorithm>

namespace ar3d::optimum {
namespace {

class AutomorphismSearch {
 public:
  explicit AutomorphismSearch(const Graph& graph)
      : graph_(graph), adjacent_(graph.num_vertices()), order_{0} {
    for (auto& row : adjacent_) row.assign(graph.num_vertices(), false);
    for (const auto [u, v] : graph.edges()) adjacent_[u][v] = adjacent_[v][u] = true;
    std::vector<bool> seen(graph.num_vertices());
    seen[0] = true;
    for (std::size_t at = 0; at < order_.size(); ++at) {
      for (const HalfEdge& half : graph.incident(order_[at])) {
        if (!seen[half.to]) order_.push_back(half.to);
        seen[half.to] = true;
      }
    }
  }

  /// Is there one that fixes all vertices below i and maps i to j?
  bool exists(Vertex i, Vertex j) {
    fixed_ = i;
    to_ = j;
    image_.assign(graph_.num_vertices(), kNone);
    used_.assign(graph_.num_vertices(), false);
    return extend(0);
  }

 private:
  static constexpr Vertex kNone = ~Vertex{0};

  bool extend(std::size_t at) {
    if (at == order_.size()) return true;
    const Vertex v = order_[at];
    for (Vertex x = 0; x < graph_.num_vertices(); ++x) {
      if (used_[x] || !fits(v, x)) continue;
      image_[v] = x;
      used_[x] = true;
      if (extend(at + 1)) return true;
      image_[v] = kNone;
      used_[x] = false;
    }
    return false;
  }

  bool fits(Vertex v, Vertex x) const {
    if (v < fixed_ && x != v) return false;
    if (v == fixed_ && x != to_) return false;
    if (graph_.degree(v) != graph_.degree(x)) return false;
    for (Vertex u = 0; u < graph_.num_vertices(); ++u) {
      if (image_[u] != kNone && adjacent_[u][v] != adjacent_[image_[u]][x]) return false;
    }
    return true;
  }

  const Graph& graph_;
  std::vector<std::vector<bool>> adjacent_;
  std::vector<Vertex> order_;  // each beside an earlier one
  Vertex fixed_ = 0;
  Vertex to_ = 0;
  std::vector<Vertex> image_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<std::pair<Vertex, Vertex>> orbit_pairs(const Graph& graph) {
  std::vector<std::pair<Vertex, Vertex>> pairs;
  AutomorphismSearch search(graph);
  for (Vertex i = 0; i < graph.num_vertices(); ++i) {
    for (Vertex j = i + 1; j < graph.num_vertices(); ++j) {
      if (search.exists(i, j)) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

}  // namespace ar3d::optimum
