#pragma once

// What Step 2.6, Lemmas 2.5 and 2.7 and Rules 2.5 to 2.7 claim of the stages of `two-bend`, decided
// slowly and plainly: tests ask after every stage, and spoil a stage to see the condition fail.

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <tuple>

#include "ar3d/algorithms/two_bend/layout.h"
#include "ar3d/algorithms/two_bend/slab.h"

namespace ar3d::two_bend {

/// Neighbours of v on one side of it in `place`.
inline unsigned count_side(const LocalGraph& graph, const LongVector<std::uint32_t>& place,
                           Vertex v, bool later) {
  const NeighbourList& near = graph.neighbours[v];
  unsigned count = 0;
  for (std::size_t k = 0; k < near.degree(); ++k) {
    if ((place[near.to[k]] > place[v]) == later) ++count;
  }
  return count;
}

/// Of a vertex whose neighbours are all on the side `!later`: how many have no other on this side.
inline unsigned count_closing(const LocalGraph& graph, const LongVector<std::uint32_t>& place,
                              Vertex v, bool later) {
  unsigned count = 0;
  for (const Vertex u : graph.neighbours[v].to) {
    count += graph.neighbours[u].degree() == 3 && count_side(graph, place, u, later) == 1 ? 1u : 0u;
  }
  return count;
}

/// The list is an order of all its vertices in which exactly the first has no earlier neighbour,
/// and every vertex of degree 3 without a later (an earlier) neighbour has two neighbours that have
/// no other later (earlier) one.
inline bool is_time_order(const LocalGraph& graph, const TimeOrder& order) {
  LongVector<std::uint32_t> place(graph.size(), kNone);
  for (std::uint32_t i = 0; i < order.list.size(); ++i) place[order.list[i]] = i;
  for (const Vertex v : order.list) {
    const bool is_first = v == order.list.front();
    if ((count_side(graph, place, v, false) == 0) != is_first) return false;
    if (graph.neighbours[v].degree() < 3) continue;
    for (const bool later : {false, true}) {
      if (count_side(graph, place, v, later) == 0 && count_closing(graph, place, v, later) < 2)
        return false;
    }
  }
  return true;
}

/// No two long edges join the same SPLIT to the same MERGE.
inline bool arms_are_not_parallel(const Flow& flow) {
  return std::none_of(flow.nodes.begin(), flow.nodes.end(), [&](const Node& node) {
    const std::size_t first = node.ins;
    return node.type == NodeType::split && node.neighbour[first] == node.neighbour[first + 1];
  });
}

/// Every listed MERGE stands strictly between its in-neighbours' rows in the list of the view.
inline bool merges_are_between(const View& view, const LongVector<NodeId>& list) {
  const Values place = list_indices(view, list);
  for (NodeId m = 0; m < view.size(); ++m) {
    if (!view.is_listed_merge(m)) continue;
    const auto below = view.ins(m);
    if ((place[below[0]] < place[m]) == (place[below[1]] < place[m])) return false;
  }
  return true;
}

/// Owners even, all MERGEs of the view but straight ones odd and between their in-neighbours, at
/// the distances that Values promises.
inline bool merges_keep_distances(const View& view, const Values& values) {
  const auto least = [&](NodeId u) {
    return view.type(u) == NodeType::station ? 2 : view.type(u) == NodeType::merge ? 2 : 1;
  };
  for (NodeId m = 0; m < view.size(); ++m) {
    if (view.is_owner(m) && values[m] % 2 != 0) return false;
    if (view.type(m) != NodeType::merge) continue;
    const NodeId a = view.ins(m)[0];
    const NodeId b = view.ins(m)[1];
    if ((values[a] < values[m]) == (values[b] < values[m])) return false;
    for (const NodeId u : {a, b}) {
      if (std::abs(values[u] - values[m]) < least(u)) return false;
    }
    const auto above = view.outs(m);
    const bool is_straight =
        !above.empty() && view.type(above[0]) == NodeType::split && values[m] == values[above[0]];
    if (values[m] % 2 == 0 && !is_straight) return false;
  }
  return true;
}

/// Rays at one (x, y) belong to edges whose spans of time do not overlap.
inline bool rays_differ(const Flow& flow, const Layout& layout) {
  using Span = std::tuple<std::int64_t, std::int64_t, NodeId, NodeId>;  // x, y, from, to
  LongVector<Span> spans;
  for (const LongEdge& edge : flow.edges) {
    const Point ray = ray_of(flow, layout, edge);
    spans.emplace_back(ray.x, ray.y, edge.lower, edge.upper);
  }
  std::sort(spans.begin(), spans.end());
  return std::adjacent_find(spans.begin(), spans.end(), [](const Span& a, const Span& b) {
           return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b) &&
                  std::get<3>(a) > std::get<2>(b);
         }) == spans.end();
}

/// Every VV lean is straight up or primitive.
inline bool vv_leans_are_primitive(const Flow& flow, const Layout& layout) {
  const LongVector<LongId>& edges = flow.vv_edges;
  return std::all_of(edges.begin(), edges.end(), [&](LongId e) {
    const NodeId m = flow.edges[e].lower;
    const NodeId s = flow.edges[e].upper;
    const auto dx = layout.columns[s] - layout.columns[m];
    const auto dy = layout.rows[s] - layout.rows[m];
    return (dx == 0 && dy == 0) || std::gcd(dx, dy) == 1;
  });
}

}  // namespace ar3d::two_bend
