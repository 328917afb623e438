// Step F.1: every edge gets 64 bits: a random number if it is not in a spanning forest, else the
// exclusive or of the numbers of the edges whose cycle passes it. Bridges have 0, and other edges by
// accident only; so a breadth-first search decides, and after an accident other numbers are taken.
// Cost: O(n) expected.
#include <fmt/format.h>

#include <vector>

#include "ar3d/algorithms/two_bend_120/cubic.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"

namespace ar3d::two_bend_120 {
namespace {

constexpr const char* kDraws =
    "two-bend-120 draws graphs whose components are cubic and have no bridge";

/// True if the ends of the edge stay connected without it. O(n).
bool connected_without(const Graph& graph, EdgeId one) {
  std::vector<bool> seen(graph.num_vertices());
  std::vector<Vertex> queue{graph.edge(one).u};
  seen[queue[0]] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const HalfEdge& half : graph.incident(queue[i])) {
      if (half.edge == one || seen[half.to]) continue;
      seen[half.to] = true;
      queue.push_back(half.to);
    }
  }
  return seen[graph.edge(one).v];
}

/// A breadth-first spanning forest: vertices in the order of the search, and the edge to the parent.
struct SearchForest {
  static constexpr EdgeId kNoEdge = std::numeric_limits<EdgeId>::max();
  explicit SearchForest(const Graph& graph) : parent_edge(graph.num_vertices(), kNoEdge) {
    std::vector<bool> seen(graph.num_vertices());
    order.reserve(graph.num_vertices());
    for (Vertex root = 0; root < graph.num_vertices(); ++root) {
      if (seen[root]) continue;
      seen[root] = true;
      order.push_back(root);
      for (std::size_t i = order.size() - 1; i < order.size(); ++i) {
        for (const HalfEdge& half : graph.incident(order[i])) {
          if (seen[half.to]) continue;
          seen[half.to] = true;
          parent_edge[half.to] = half.edge;
          order.push_back(half.to);
        }
      }
    }
  }
  std::vector<Vertex> order;
  std::vector<EdgeId> parent_edge;
};

/// The bits of all edges.
std::vector<std::uint64_t> bits_of_edges(const Graph& graph, const SearchForest& forest,
                                         std::uint64_t seed) {
  std::vector<std::uint64_t> bits(graph.num_edges());
  for (EdgeId e = 0; e < graph.num_edges(); ++e) bits[e] = mix_seed(seed, e);
  for (const EdgeId e : forest.parent_edge) {
    if (e != SearchForest::kNoEdge) bits[e] = 0;
  }
  for (std::size_t i = forest.order.size(); i-- > 0;) {
    const Vertex v = forest.order[i];
    const EdgeId up = forest.parent_edge[v];
    if (up == SearchForest::kNoEdge) continue;
    std::uint64_t sum = 0;  // of all edges at v: those below are known
    for (const HalfEdge& half : graph.incident(v)) sum ^= bits[half.edge];
    bits[up] = sum;
  }
  return bits;
}

}  // namespace

void refuse_bridges(const Graph& graph) {
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (graph.degree(v) == 3) continue;
    throw InputError(fmt::format("{}, but vertex {} has degree {} (vertices count from 0)", kDraws,
                                 v, graph.degree(v)));
  }
  const SearchForest forest(graph);
  bool accident = true;
  for (std::uint64_t seed = 0; accident; ++seed) {
    const std::vector<std::uint64_t> bits = bits_of_edges(graph, forest, seed);
    accident = false;
    for (EdgeId e = 0; e < graph.num_edges() && !accident; ++e) {
      if (bits[e] != 0) continue;
      accident = connected_without(graph, e);
      if (accident) continue;
      throw InputError(fmt::format("{}, but edge {} - {} is a bridge (vertices count from 0)",
                                   kDraws, graph.edge(e).u, graph.edge(e).v));
    }
  }
}

}  // namespace ar3d::two_bend_120
