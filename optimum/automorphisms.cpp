// Steps O.9 and O.10 of the formula: of drawings that a symmetry of the graph or of the box maps to
// each other, one is enough. Automorphisms of a small graph are found by trying: images are chosen
// vertex by vertex, each beside the image of an earlier neighbour, so that few are to be tried.
#include <algorithm>

#include "ar3d/model/isomorphism.h"
#include "ar3d/optimum/encoding.h"

namespace ar3d::optimum {
std::vector<std::pair<Vertex, Vertex>> orbit_pairs(const Graph& graph) {
  std::vector<Vertex> order = {0};  // each beside an earlier one
  for (std::size_t at = 0; at < order.size(); ++at) {
    for (const HalfEdge& half : graph.incident(order[at])) {
      if (std::ranges::count(order, half.to) == 0) order.push_back(half.to);
    }
  }
  std::vector<std::pair<Vertex, Vertex>> pairs;
  for (Vertex i = 0; i < graph.num_vertices(); ++i) {
    for (Vertex j = i + 1; j < graph.num_vertices(); ++j) {
      const auto fixes = [&](Vertex v, Vertex x) { return v > i || x == (v < i ? v : j); };
      if (find_isomorphism(graph, graph, order, fixes)) pairs.emplace_back(i, j);
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
