// Theorem 3 with O(n) per side: order, labels and plane numbers, packing, routes. The outline of
// docs/theorem3.md as a function, and the theorem as data in the catalogue's row. Cost: O(n log n)
// expected, on every input (Lemma 3.7).
#include "ar3d/algorithms/grid/grid.h"

#include <cstdlib>

#include "ar3d/algorithms/efforts.h"
#include "ar3d/algorithms/grid/order.h"
#include "ar3d/algorithms/grid/planes.h"

namespace ar3d::grid {
namespace {

constexpr int kHighestEffort = 2;

std::int64_t largest_coordinate(const Planes& planes) {
  std::int64_t largest = 0;
  for (const PlaneNumbers& x : planes.of) {
    const Point p = position(x);
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return largest;
}

/// The size proof for the plane numbers at hand, before components are packed: a component whose
/// numbers are at most P in absolute value has extents of at most 12 P + 100; side by side they
/// need at most the sum, each with a margin of 12.
std::int64_t own_side(const ProcessingOrder& order, const Planes& planes) {
  const std::int64_t margin = order.parts.size() > 1 ? 12 : 0;
  std::int64_t side = 0;
  for (const OrderPart& part : order.parts) {
    std::int64_t largest = 0;  // P
    for (std::size_t i = part.begin; i < part.end; ++i) {
      if (i + kAhead < part.end) __builtin_prefetch(&planes.of[order.sequence[i + kAhead]]);
      for (const std::int64_t x : planes.of[order.sequence[i]]) {
        largest = std::max(largest, std::abs(x));
      }
    }
    side += 12 * largest + 100 + margin;
  }
  return side;
}

Drawing to_drawing(const Graph& graph, Planes planes) {
  Coordinates vertices(graph.num_vertices(), largest_coordinate(planes));
  for (Vertex v = 0; v < graph.num_vertices(); ++v) vertices.set(v, position(planes.of[v]));
  const PlaneCounts counts = planes.counts;
  auto routes = std::make_shared<Routes>(std::move(planes.labels), std::move(planes.slots));
  Drawing drawing("grid", kCubeLattice, std::move(vertices), graph.shared_edges(),
                  std::move(routes));
  drawing.counters = {{"nt", counts.nt},
                      {"pq", counts.pq},
                      {"last_u", counts.last_edge_u},
                      {"last_m", counts.last_edge_m},
                      {"last_p", counts.last_edge_p},
                      {"restarts", counts.restarts},
                      {"flat_defects", counts.flat_defects},
                      {"core_parts", counts.core_parts}};
  return drawing;
}

Drawing draw_alone(const Graph& graph, const Options& options) {
  const ProcessingOrder order = processing_order(graph);
  Planes planes = assign_planes(graph, order, {.flat = options.effort > 0});
  const std::int64_t side = own_side(order, planes);
  pack_components(graph, order, planes);
  Drawing drawing = to_drawing(graph, std::move(planes));
  if (graph.num_vertices() > 0) drawing.instance_bound = {side, side, side};
  return options.effort == 2 ? squeezed(graph, std::move(drawing)) : drawing;
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  check_effort("grid", options.effort, kHighestEffort);
  refuse_larger_degrees("grid", graph, 3);
  return smallest_of_efforts(graph, options, draw_alone);
}

Algorithm row() {
  const AxisBound own = linear(5600) + 3700;
  const AxisBound paper = cubic(1);  // O(n^3) is stated without a constant; 1 stands for it
  Algorithm row;
  row.name = "grid";
  row.summary = "degree at most 3, at most 3 bends per edge, all angles 120 degrees, O(n) per side";
  row.source = "Theorem 3";
  row.guarantee = {
      .max_degree = 3,
      .max_bends = 3,
      .angle_rule = AngleRule::exactly,
      .cosine = {-1, 2},
      .lattice = kCubeLattice,
      .directions = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}},
      .bound = {"proved here", "docs/theorem3.md", {own, own, own}},
      .published = {{"paper; order only, constant 1 assumed", "Theorem 3", {paper, paper, paper}}},
  };
  row.options = {effort_option(
      kHighestEffort, "0: the proved core; 1: flat numbers where that is possible; 2: squeezed")};
  row.draw = draw_with_effort<draw>;
  return row;
}

}  // namespace ar3d::grid
