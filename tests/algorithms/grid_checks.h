#pragma once

// What the tests of algorithm `grid` share.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/grid_invariant.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/grid/order.h"
#include "ar3d/algorithms/grid/planes.h"
#include "ar3d/verify/certificate.h"
#include "support/counters.h"

namespace ar3d::testing {

/// Expects that the core has used both clash rules and all three cases of the last edge.
inline void expect_all_hit(CounterSums& sums) {
  for (const char* name : {"nt", "pq", "last_u", "last_m", "last_p"})
    EXPECT_GT(sums[name], 0) << name;
}

/// Draws and certifies. "" or the first violation; small graphs with their edges.
inline std::string grid_fault(const Graph& graph, std::int64_t effort,
                              CounterSums* sums = nullptr) {
  const Algorithm& grid = find_algorithm("grid");
  const Drawing drawing = draw(grid, graph, {{"effort", effort}});
  if (sums != nullptr) add_counters(drawing, *sums);
  const Certificate certificate = certify(graph, drawing, grid.guarantee);
  const auto extents = bounding_box(drawing).extents();
  for (std::size_t axis = 0; axis < 3 && graph.num_vertices() > 0; ++axis) {
    EXPECT_LE(extents[axis], drawing.instance_bound.value()[axis]) << "the proof's own bound";
  }
  if (certificate.valid()) return "";
  if (certificate.violations.empty()) return "incomplete certificate";
  std::string text = certificate.violations[0].message;
  if (graph.num_edges() > 40) return text;
  for (const Edge e : graph.edges()) text += fmt::format(" {}-{}", e.u, e.v);
  return text;
}

inline grid::Planes planes_of(const Graph& graph, const grid::PlaneOptions& options) {
  const grid::ProcessingOrder order = grid::processing_order(graph);
  grid::Planes planes = grid::assign_planes(graph, order, options);
  grid::pack_components(graph, order, planes);
  return planes;
}

/// Many defects: the core without Kempe chains.
inline grid::Planes core_planes(const Graph& graph) { return planes_of(graph, {.flat = false}); }

inline Drawing drawing_of(const Graph& graph, const grid::Planes& planes) {
  Coordinates vertices(graph.num_vertices(), 1'000'000);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) vertices.set(v, grid::position(planes.of[v]));
  return Drawing("grid", kCubeLattice, std::move(vertices), graph.shared_edges(),
                 std::make_shared<grid::Routes>(planes.labels, planes.slots));
}

/// Triangles inside one another: each vertex has at most one edge to the next triangle inwards or
/// outwards.
inline Graph nested_cubic_triangles(Vertex depth) {
  std::vector<Edge> edges;
  for (Vertex i = 0; i < depth; ++i) {
    const Vertex a = 3 * i;
    edges.insert(edges.end(), {{a, a + 1}, {a + 1, a + 2}, {a, a + 2}});
    if (i + 1 == depth) break;
    edges.push_back({a + 1, a + 3});  // this triangle's second to the next one's first
    if (i % 2 == 0) edges.push_back({a + 2, a + 5});  // third to third, every other time
  }
  return Graph(3 * std::uint64_t{depth}, std::move(edges));
}

}  // namespace ar3d::testing
