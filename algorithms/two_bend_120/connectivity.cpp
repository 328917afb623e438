// Step F.1: a cubic graph with at least four vertices is 3-connected iff no two edges cut it. Every
// edge gets 64 bits: a random number if it is not in a spanning forest, else the exclusive or of
// the numbers of the edges whose cycle passes it. An edge with 0 is then a bridge, and two edges
// with equal bits are a cut, but for accidents; so a breadth-first search decides each such case,
// and after an accident other numbers are taken. Bridges and cuts of two edges always show. Cost:
// O(n log n) expected for the sort.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ar3d/algorithms/two_bend_120/cubic.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"

namespace ar3d::two_bend_120 {
namespace {

constexpr const char* kDraws =
    "two-bend-120 draws graphs whose components are cubic and 3-connected";

/// True if the ends of `one` stay connected without the edges `one` and `other`. O(n).
bool connected_without(const Graph& graph, EdgeId one, EdgeId other) {
  std::vector<bool> seen(graph.num_vertices());
  std::vector<Vertex> queue{graph.edge(one).u};
  seen[queue[0]] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const HalfEdge& half : graph.incident(queue[i])) {
      if (half.edge == one || half.edge == other || seen[half.to]) continue;
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

/// The bits of all edges, each with its edge, ascending.
std::vector<std::pair<std::uint64_t, EdgeId>> bits_of_edges(const Graph& graph,
                                                            const SearchForest& forest,
                                                            std::uint64_t seed) {
  std::vector<std::pair<std::uint64_t, EdgeId>> bits(graph.num_edges());
  for (EdgeId e = 0; e < graph.num_edges(); ++e) bits[e] = {mix_seed(seed, e), e};
  for (const EdgeId e : forest.parent_edge) {
    if (e != SearchForest::kNoEdge) bits[e].first = 0;
  }
  for (std::size_t i = forest.order.size(); i-- > 0;) {
    const Vertex v = forest.order[i];
    const EdgeId up = forest.parent_edge[v];
    if (up == SearchForest::kNoEdge) continue;
    std::uint64_t sum = 0;  // of all edges at v: those below are known
    for (const HalfEdge& half : graph.incident(v)) sum ^= bits[half.edge].first;
    bits[up].first = sum;
  }
  std::sort(bits.begin(), bits.end());
  return bits;
}

}  // namespace

void refuse_small_cuts(const Graph& graph) {
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (graph.degree(v) == 3) continue;
    throw InputError(fmt::format("{}, but vertex {} has degree {} (vertices count from 0)", kDraws,
                                 v, graph.degree(v)));
  }
  const SearchForest forest(graph);
  const auto name = [&](EdgeId e) {
    return fmt::format("{} - {}", graph.edge(e).u, graph.edge(e).v);
  };
  bool accident = true;
  for (std::uint64_t seed = 0; accident; ++seed) {
    accident = false;
    const auto bits = bits_of_edges(graph, forest, seed);
    for (std::size_t i = 0; i < bits.size() && !accident; ++i) {
      const EdgeId e = bits[i].second;
      const bool is_alone = bits[i].first == 0;
      if (!is_alone && (i == 0 || bits[i - 1].first != bits[i].first)) continue;
      const EdgeId other = is_alone ? e : bits[i - 1].second;
      accident = connected_without(graph, e, other);
      if (accident) continue;
      const std::string cut =
          is_alone ? fmt::format("edge {} is a bridge", name(e))
                   : fmt::format("edges {} and {} together cut one", name(other), name(e));
      throw InputError(fmt::format("{}, but {} (vertices count from 0)", kDraws, cut));
    }
  }
}

}  // namespace ar3d::two_bend_120
