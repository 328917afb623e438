// Steps O.9 and O.10 of the formula: of drawings that a symmetry of the graph or of the box maps to
// each other, one is enough. Automorphisms of a small graph are found by trying: images are chosen
// vertex by vertex, each beside the image of an earlier neighbour, so that few are to be tried.
#include <algorithm>

#include "ar3d/optimum/encoding.h"

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

// Vertices that a stabiliser of the chain maps to each other have ascending positions.
void Encoding::break_graph_symmetry() {
  for (const auto& [first, second] : orbit_pairs(graph_)) {
    formula_.add({-vertex_at_[second][0]});
    for (std::size_t p = 1; p < points_.points.size(); ++p) {
      formula_.add({-vertex_at_[second][p], vertex_until_[first][p - 1]});
    }
  }
}

// The set of points with vertices is not smaller than any image, as a word of 0 and 1.
void Encoding::break_box_symmetry() {
  constexpr int kMostCompared = 60;  // a prefix of the words, which is weaker and enough
  for (const std::vector<int>& images : points_.symmetries) {
    int equal_so_far = 0;
    int compared = 0;
    for (std::size_t p = 0; p < images.size() && compared < kMostCompared; ++p) {
      if (images[p] == static_cast<int>(p)) continue;
      ++compared;
      const int own = is_vertex_[p];
      const int other = is_vertex_[static_cast<std::size_t>(images[p])];
      const int equal = formula_.new_variable();
      for (const auto& [of, to] : {std::pair{-other, own}, {own, equal}, {-other, equal}}) {
        Row clause;
        if (equal_so_far != 0) clause.push_back(-equal_so_far);
        clause.insert(clause.end(), {of, to});
        formula_.add(clause);
      }
      equal_so_far = equal;
    }
  }
}

}  // namespace ar3d::optimum
