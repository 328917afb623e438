#pragma once

#include <string>
#include <vector>

#include "ar3d/algorithms/two_bend_120/two_bend_120.h"
#include "ar3d/base/error.h"
#include "ar3d/verify/certificate.h"
#include "support/graphs.h"

namespace ar3d::testing {

/// Empty if the graph's drawing is proved right, else what is wrong or why it is refused.
inline std::string two_bend_120_fault(const Graph& graph) {
  static const Algorithm row = two_bend_120::row();
  try {
    const Certificate certificate = certify(graph, two_bend_120::draw(graph), row.guarantee);
    return certificate.valid() ? "" : certificate.violations[0].message;
  } catch (const InputError& error) {
    return error.what();
  }
}

/// True if all vertices but two are connected. O(n).
inline bool is_connected_without(const Graph& graph, Vertex u, Vertex v) {
  std::vector<bool> seen(graph.num_vertices());
  seen[u] = seen[v] = true;
  std::vector<Vertex> found;
  for (Vertex w = 0; found.empty() && w < 3; ++w) {
    if (!seen[w]) found.push_back(w);
  }
  seen[found[0]] = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const HalfEdge& half : graph.incident(found[i])) {
      if (!seen[half.to]) found.push_back(half.to);
      seen[half.to] = true;
    }
  }
  return found.size() + (u == v ? 1 : 2) == graph.num_vertices();
}

/// By trial of all pairs of vertices: O(n^3).
inline bool is_cubic_and_3_connected(const Graph& graph) {
  for (Vertex u = 0; u < graph.num_vertices(); ++u) {
    if (graph.degree(u) != 3) return false;
    for (Vertex v = 0; v <= u; ++v) {
      if (!is_connected_without(graph, u, v)) return false;
    }
  }
  return graph.num_vertices() > 0;
}

/// Whether the graph is drawn, which is certified then; what has to be drawn is.
inline bool is_drawn_or_refused_120(const Graph& graph, bool has_to_be_drawn) {
  const std::string fault = two_bend_120_fault(graph);
  const bool is_refused = fault.starts_with("two-bend-120 ");
  EXPECT_TRUE(fault.empty() || (is_refused && !has_to_be_drawn)) << fault;
  return fault.empty();
}

/// The cubic graph with vertex v replaced by a triangle, of v and the two last vertices; v keeps its
/// edge to its first neighbour.
inline Graph with_triangle(const Graph& graph, Vertex v) {
  const Vertex n = graph.num_vertices();
  std::vector<Edge> edges{{v, n}, {v, n + 1}, {n, n + 1}};
  for (const Edge& edge : graph.edges()) {
    const Vertex other = edge.u == v ? edge.v : edge.u;
    const bool stays = (edge.u != v && edge.v != v) || other == graph.incident(v)[0].to;
    edges.push_back(stays ? edge : Edge{other, other == graph.incident(v)[1].to ? n : n + 1});
  }
  return Graph(n + 2, std::move(edges));
}

}  // namespace ar3d::testing
