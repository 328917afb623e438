// Routed drawings, the outline of docs/routed.md: the fall-back keeps a theorem for every input
// (Step R.1), the routing is kept where it is smaller, and is a drawing by Lemma R.2. The rows of the
// catalogue promise the box of the fall-back without its plane, since vertices lie in space. Cost:
// the fall-back's, and the searches of boxes.cpp.
#include "ar3d/algorithms/routed/routed.h"

#include <fmt/format.h>

#include "ar3d/algorithms/compact/compact.h"
#include "ar3d/algorithms/compact_120/compact_120.h"
#include "ar3d/algorithms/diamond/diamond.h"
#include "ar3d/algorithms/efforts.h"
#include "ar3d/algorithms/grid/grid.h"
#include "ar3d/algorithms/routed/boxes.h"
#include "ar3d/base/error.h"

namespace ar3d::routed {
namespace {

constexpr int kHighestEffort = 2;
constexpr std::uint32_t kMostVertices = 1u << 27;  // of the fall-backs
constexpr std::uint32_t kMostRouted = 10000;       // larger graphs have not been tried
constexpr int kMostMegabytes = 100000;

/// The same drawing under the algorithm's own name.
Drawing renamed(const std::string& name, const Graph& graph, const Drawing& drawing) {
  const Box box = bounding_box(drawing);
  std::int64_t largest = 0;
  for (const std::int64_t c :
       {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z}) {
    largest = std::max(largest, std::abs(c));
  }
  Coordinates vertices(drawing.num_vertices(), largest);
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) vertices.set(v, drawing.vertex(v));
  Drawing result(name, drawing.lattice(), std::move(vertices), graph.shared_edges(),
                 drawing.shared_bends());
  result.instance_bound = drawing.instance_bound;
  return result;
}

/// Step R.1: the drawing that a theorem gives.
Drawing fall_back(const Algorithm& row, const Graph& graph, const Options& options) {
  const bool is_body = row.guarantee.max_degree == 4;
  Drawing first = is_body ? diamond::draw(graph, {.effort = options.effort})
                          : grid::draw(graph, {.effort = options.effort});
  if (options.bends == 5) {
    Drawing other = is_body ? compact::draw(graph, {.effort = options.effort})
                            : compact_120::draw(graph, {.effort = options.effort});
    const auto extents = bounding_box(other).extents();
    if (row.guarantee.bound.holds(extents, graph.num_vertices()) &&
        volume_of(extents) < volume_of(bounding_box(first).extents())) {
      return renamed(row.name, graph, other);
    }
  }
  return renamed(row.name, graph, first);
}

/// The routing in space, the low corner of its box at the origin.
Drawing to_drawing(const std::string& name, const Graph& graph, const PointClass& points,
                   const Routing& routing) {
  const Limits& limits = routing.layout.limits;
  const auto point = [&](Spot p) {
    const Spot d = p - limits.low;
    return Point{d.x, d.y, d.z};
  };
  Coordinates vertices(graph.num_vertices(), limits.longest());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) vertices.set(v, point(routing.layout.at[v]));
  auto bends = std::make_shared<StoredBends>();
  std::vector<Point> of_edge;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    of_edge.clear();
    for_each_corner(points, routing.layout.at[graph.edge(e).u], routing.routes[e],
                    [&](Spot p) { of_edge.push_back(point(p)); });
    of_edge.pop_back();  // the other end
    bends->add_edge(of_edge);
  }
  return {name, kCubeLattice, std::move(vertices), graph.shared_edges(), std::move(bends)};
}

bool fits_within(const std::array<std::int64_t, 3>& extents,
                 const std::array<std::int64_t, 3>& bound) {
  return extents[0] <= bound[0] && extents[1] <= bound[1] && extents[2] <= bound[2];
}

void refuse_too_large(const Algorithm& row, const Options& options, const Limits& box,
                      std::int64_t bytes) {
  if (bytes <= std::int64_t{options.megabytes} * 1000000) return;
  const Spot sides = box.sides();
  throw InputError(fmt::format(
      "{} needs {} MB for the points of a {} x {} x {} box, but option megabytes allows {}",
      row.name, (bytes + 999999) / 1000000, sides.x, sides.y, sides.z, options.megabytes));
}

/// Replaces the fall-back by a routing if that is smaller and keeps the row's box.
bool keep_routing(const Algorithm& row, const Graph& graph, const PointClass& points,
                  const Options& options, BoxCounts& counts, Drawing& drawing) {
  if (graph.num_vertices() == 0 || graph.num_vertices() > kMostRouted) return false;
  const Limits first = first_box(points, options.bends, graph.num_vertices());
  refuse_too_large(row, options, first, CostBox::bytes(points, first));
  const auto routing = smallest_routing(graph, points, options.bends, options.effort,
                                        std::int64_t{options.megabytes} * 1000000, counts);
  if (!routing) return false;
  const Spot sides = routing->layout.limits.sides();
  const std::array<std::int64_t, 3> extents = {sides.x - 1, sides.y - 1, sides.z - 1};
  if (!row.guarantee.bound.holds(extents, graph.num_vertices()) ||
      volume_of(extents) > volume_of(bounding_box(drawing).extents())) {
    return false;
  }
  auto bound = drawing.instance_bound;
  if (bound && !fits_within(extents, *bound)) bound.reset();
  drawing = to_drawing(row.name, graph, points, *routing);
  drawing.instance_bound = bound;
  return true;
}

/// The smaller of the fall-back and the routing.
Drawing smaller_of_both(const Algorithm& row, const Graph& graph, const PointClass& points,
                        const Options& options) {
  Drawing drawing = fall_back(row, graph, options);
  BoxCounts counts;
  const bool is_routed = keep_routing(row, graph, points, options, counts, drawing);
  drawing.counters = {{"routed", is_routed ? 1 : 0},
                      {"boxes", counts.boxes},
                      {"legal_boxes", counts.legal},
                      {"searches", static_cast<std::int64_t>(counts.searches)},
                      {"conflicts", static_cast<std::int64_t>(counts.conflicts)},
                      {"bytes", counts.bytes}};
  return drawing;
}

void check_range(const std::string& name, const char* option, int value, int low, int high) {
  if (value >= low && value <= high) return;
  throw InputError(
      fmt::format("{} takes {} from {} to {}, not {}", name, option, low, high, value));
}

Drawing draw(const Algorithm& row, const Graph& graph, const PointClass& points,
             const Options& options) {
  check_effort(row.name, options.effort, kHighestEffort);
  check_range(row.name, "bends", options.bends, 3, kMostBends);
  check_range(row.name, "megabytes", options.megabytes, 1, kMostMegabytes);
  refuse_larger_degrees(row.name, graph, row.guarantee.max_degree);
  refuse_more_vertices(row.name, graph, kMostVertices);
  return smaller_of_both(row, graph, points, options);
}

Options options_of(const Settings& values) {
  const auto value = [&](const char* name) { return static_cast<int>(value_of(values, name)); };
  return {value("effort"), value("bends"), value("megabytes")};
}

/// A row of this folder; the guarantee is that of the fall-back, except for the bends of the largest
/// option and the plane.
Algorithm row_like(Algorithm fall_back, const char* name, const char* summary, const char* source,
                   Drawing (*draw)(const Graph&, const Options&), const PointClass& (*points)()) {
  Algorithm row;
  row.name = name;
  row.summary = summary;
  row.source = source;
  row.draw = [draw](const Graph& graph, const Settings& values) {
    return draw(graph, options_of(values));
  };
  row.guarantee = std::move(fall_back.guarantee);
  row.guarantee.max_bends = kMostBends;
  row.guarantee.vertices_in_plane = false;
  row.guarantee.bound.source = "docs/routed.md";
  row.guarantee.published = {};
  row.by_name_only = true;
  row.space = [points](const Settings& values, std::uint64_t n) {
    if (n > kMostRouted) return 1.0;
    return static_cast<double>(
        CostBox::bytes(points(), first_box(points(), options_of(values).bends, n)));
  };
  row.options = {
      effort_option(kHighestEffort,
                    "0: the first legal box; 1: smaller boxes; 2: ten times as many"),
      {"bends", 3, kMostBends, 3, "at most so many bends per edge"},
      {"megabytes", 1, kMostMegabytes, 1000, "memory that the points of a box may take"}};
  return row;
}

}  // namespace

Drawing draw_109(const Graph& graph, const Options& options) {
  static const Algorithm row = row_109();
  return draw(row, graph, PointClass::body(), options);
}

Drawing draw_120(const Graph& graph, const Options& options) {
  static const Algorithm row = row_120();
  return draw(row, graph, PointClass::face(), options);
}

Algorithm row_109() {
  return row_like(diamond::row(), "routed",
                  "degree at most 4, at most 3 to 5 bends, all angles 109.47 degrees, small boxes",
                  "Theorem 1", draw_109, PointClass::body);
}

Algorithm row_120() {
  return row_like(grid::row(), "routed-120",
                  "degree at most 3, at most 3 to 5 bends, all angles 120 degrees, small boxes",
                  "Theorem 3", draw_120, PointClass::face);
}

}  // namespace ar3d::routed
