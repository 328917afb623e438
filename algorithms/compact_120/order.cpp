// Steps D.1 to D.3: who is left of whom. Colours give few ranks; a source or sink of degree 3
// passes one neighbour where that makes it none and no other vertex one. One vertex after the
// other, each judged by the moves so far: all at once, two sources could pass one neighbour and
// make it a source. Cost: O(n), and O(n log n) for the levels.
#include "ar3d/algorithms/compact_120/order.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace ar3d::compact_120 {
namespace {

constexpr std::uint32_t kColourStep = 100;  ///< ranks between two colours
constexpr std::uint32_t kSourceStep = 5;    ///< between sources of different colours that moved

/// Neighbours of v to the right (or left).
int count(const Graph& graph, const Order& order, Vertex v, bool right) {
  int found = 0;
  for (const HalfEdge& edge : graph.incident(v)) found += order.is_right(v, edge.to) == right;
  return found;
}

/// The neighbour that a source or sink would pass: the nearest one.
Vertex nearest(const Graph& graph, const Order& order, Vertex v, bool source) {
  Vertex best = graph.incident(v)[0].to;
  for (const HalfEdge& edge : graph.incident(v)) {
    if (order.is_right(edge.to, best) == source) best = edge.to;
  }
  return best;
}

/// Is v a source or sink of degree 3 that may pass its nearest neighbour, as that one has another
/// neighbour on v's side?
bool may_move(const Graph& graph, const Order& order, Vertex v, bool source) {
  return graph.degree(v) == 3 && count(graph, order, v, source) == 3 &&
         count(graph, order, nearest(graph, order, v, source), !source) >= 2;
}

}  // namespace

std::vector<std::uint8_t> distance_two_colours(const Graph& graph) {
  constexpr std::uint8_t kNone = 255;
  std::vector<std::uint8_t> colours(graph.num_vertices(), kNone);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    unsigned used = 0;
    const auto use = [&](Vertex u) {
      if (colours[u] != kNone) used |= 1u << colours[u];
    };
    for (const HalfEdge& edge : graph.incident(v)) {
      use(edge.to);
      for (const HalfEdge& next : graph.incident(edge.to)) use(next.to);
    }
    colours[v] = static_cast<std::uint8_t>(std::countr_one(used));
  }
  return colours;
}

Order moved_order(const Graph& graph) {
  const std::vector<std::uint8_t> colours = distance_two_colours(graph);
  Order order;
  order.rank.reserve(colours.size());
  const auto rank_of = [](std::uint32_t rank) { return static_cast<std::uint16_t>(rank); };
  for (const std::uint8_t colour : colours) {
    order.rank.push_back(rank_of(kColourStep * (colour + 1u)));
  }
  const auto rank_beside = [&](Vertex v, bool source) {
    return order.rank[nearest(graph, order, v, source)];
  };
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (!may_move(graph, order, v, true)) continue;
    order.rank[v] = rank_of(rank_beside(v, true) + kSourceStep * (colours[v] + 1u));
  }
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (may_move(graph, order, v, false)) order.rank[v] = rank_of(rank_beside(v, false) - 1u);
  }
  return order;
}

Order in_levels(const Graph& graph, const Order& order) {
  std::vector<Vertex> by_rank(graph.num_vertices());
  std::iota(by_rank.begin(), by_rank.end(), 0);
  std::stable_sort(by_rank.begin(), by_rank.end(),
                   [&](Vertex a, Vertex b) { return order.rank[a] < order.rank[b]; });
  Order levels;
  levels.rank.assign(graph.num_vertices(), 0);
  for (const Vertex v : by_rank) {
    for (const HalfEdge& edge : graph.incident(v)) {
      if (!order.is_right(edge.to, v)) continue;
      levels.rank[v] =
          std::max(levels.rank[v], static_cast<std::uint16_t>(levels.rank[edge.to] + 1));
    }
  }
  return levels;
}

}  // namespace ar3d::compact_120
