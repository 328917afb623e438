#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ar3d/algorithms/two_bend_109/slots.h"
#include "ar3d/algorithms/two_bend_109/two_bend_109.h"
#include "ar3d/verify/certificate.h"

namespace ar3d::testing {

/// A drawing in the algorithm's name, with the bends of each edge.
inline Drawing two_bend_drawing(std::span<const Edge> edges, const std::vector<Point>& at,
                                const std::vector<std::vector<Point>>& bends) {
  Coordinates vertices(at.size(), kMaxCoordinate);
  for (std::size_t v = 0; v < at.size(); ++v) vertices.set(v, at[v]);
  auto stored = std::make_shared<StoredBends>();
  for (const auto& points : bends) stored->add_edge(points);
  return {"two-bend-109", two_bend_109::kAxisLattice, std::move(vertices),
          std::make_shared<const std::vector<Edge>>(edges.begin(), edges.end()), std::move(stored)};
}

/// Empty if the drawing is proved right and has two bends on every edge; else what is wrong.
inline std::string two_bend_109_fault(const Graph& graph, const Drawing& drawing) {
  static const Algorithm row = two_bend_109::row();
  const CrossingTest test =
      graph.num_vertices() <= 100 ? CrossingTest::all_pairs : CrossingTest::automatic;
  const Certificate certificate = certify(graph, drawing, row.guarantee, {.crossing_test = test});
  if (!certificate.valid()) return certificate.violations[0].message;
  const auto extents = bounding_box(drawing).extents();
  for (std::size_t axis = 0; axis < 3 && graph.num_vertices() > 0; ++axis) {
    if (!drawing.instance_bound) return "no bound of its own";
    if (extents[axis] > (*drawing.instance_bound)[axis]) return "wider than its own bound";
  }
  if (graph.num_vertices() > 0 &&
      !row.guarantee.bound.holds(*drawing.instance_bound, graph.num_vertices())) {
    return "its own bound is wider than the theorem's";
  }
  std::vector<Point> points;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    drawing.polyline(e, points);
    if (points.size() != 4) return "not two bends";
  }
  return "";
}

inline std::string two_bend_109_fault(const Graph& graph,
                                      const two_bend_109::Options& options = {}) {
  return two_bend_109_fault(graph, two_bend_109::draw(graph, options));
}

inline two_bend_109::OrderedGraph ordered(const Graph& graph) {
  return {graph, two_bend_109::find_partition(graph), connected_components_of(graph)};
}

inline std::int64_t count_109(const Drawing& drawing, const std::string& name) {
  for (const Counter& c : drawing.counters) {
    if (c.name == name) return c.value;
  }
  return -1;
}

}  // namespace ar3d::testing
