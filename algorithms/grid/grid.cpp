#include "ar3d/algorithms/grid/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "ar3d/algorithms/grid/flat.h"
#include "ar3d/algorithms/grid/invariant.h"
#include "ar3d/algorithms/grid/labels.h"
#include "ar3d/algorithms/grid/order.h"
#include "ar3d/algorithms/grid/planes.h"
#include "ar3d/algorithms/grid/routes.h"
#include "ar3d/model/error.h"

namespace ar3d {
namespace {

using grid::PlaneNumbers;
using grid::Planes;

/// The run-time form of the size proof: no plane number passes the proved bound.
std::int64_t checked_largest_number(const Planes& planes) {
  std::int64_t largest = 0;
  for (const PlaneNumbers& x : planes.of) {
    for (const std::int32_t number : x) largest = std::max(largest, std::abs(std::int64_t{number}));
  }
  const auto n = static_cast<std::int64_t>(planes.of.size());
  expect(largest <= grid::proved_plane_bound(n), "plane numbers keep the proved bound");
  return largest;
}

Drawing to_drawing(const Graph& graph, Planes planes) {
  const std::int64_t largest = checked_largest_number(planes);
  Coordinates vertices(graph.num_vertices(), 6 * largest);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) vertices.set(v, grid::position(planes.of[v]));
  const grid::PlaneCounts counts = planes.counts;
  auto routes = std::make_shared<grid::Routes>(std::move(planes.labels), std::move(planes.slots));
  Drawing drawing("grid", kCubeLattice, std::move(vertices), graph.shared_edges(),
                  std::move(routes));
  drawing.counters = {{"nt", counts.nt},
                      {"pq", counts.pq},
                      {"last_u", counts.last_edge_u},
                      {"last_m", counts.last_edge_m},
                      {"last_p", counts.last_edge_p},
                      {"restarts", counts.restarts}};
  return drawing;
}

SizeBound proved_bound() {
  const AxisBound axis{1800, 1, 2, 3700};
  return {"proved here", "docs/theorem3.md, Size", {axis, axis, axis}};
}

/// The paper states O(n^3) a side without a constant; 1 stands for it.
SizeBound paper_bound() {
  const AxisBound axis{1, 1, 6, 0};
  return {"paper; order only, constant 1 assumed", "Theorem 3", {axis, axis, axis}};
}

Drawing draw_row(const Graph& graph, const OptionValues& values) {
  return draw_grid(graph, {static_cast<int>(option(values, "effort")), option(values, "window"),
                           option(values, "kempe")});
}

}  // namespace

Drawing draw_grid(const Graph& graph, const GridOptions& options) {
  if (graph.max_degree() > 3) {
    throw InputError(
        fmt::format("grid draws graphs of maximum degree 3, not {}", graph.max_degree()));
  }
  const grid::ProcessingOrder order = grid::processing_order(graph);
  grid::Labels labels = grid::label_half_edges(
      graph, order, options.effort > 0 ? static_cast<std::size_t>(options.kempe) : 0);
  grid::PlaneOptions plane_options;
  plane_options.compact_windows = options.effort > 0;
  plane_options.window_percent = options.window;
  std::optional<Planes> flat;
  if (options.effort > 1) flat = grid::flat_planes(graph, labels);
  Planes planes =
      flat ? std::move(*flat) : grid::assign_planes(graph, order, std::move(labels), plane_options);
  expect_heavy([&] { return grid::broken_invariant(graph, planes).empty(); },
               "plane numbers, labels and slots keep (I1)-(I5)");
  return to_drawing(graph, std::move(planes));
}

Algorithm grid_row() {
  Guarantee guarantee;
  guarantee.max_degree = 3;
  guarantee.max_bends = 3;
  guarantee.angle_rule = AngleRule::exactly;
  guarantee.cosine = {-1, 2};
  guarantee.lattice = kCubeLattice;
  guarantee.directions = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}};
  guarantee.bound = proved_bound();
  guarantee.published = {paper_bound()};
  return {"grid",
          "face diagonals of the cube grid, 3 bends, exactly 120 degrees, O(n) a side",
          "Theorem 3",
          std::move(guarantee),
          {{"effort", 0, 2, 2,
            "0: the proved core; 1: and a smaller box; 2: flat if there is no defect"},
           {"window", 20, 400, 55, "half width of the preferred window, hundredths of n"},
           {"kempe", 0, 1000000, 1000000, "longest Kempe chain swapped to avoid a defect"}},
          draw_row};
}

}  // namespace ar3d
