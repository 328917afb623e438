#pragma once

#include <string>
#include <vector>

#include "ar3d/algorithms/compact_120/compact_120.h"
#include "ar3d/algorithms/compact_120/routes.h"
#include "ar3d/algorithms/compact_120/zones.h"
#include "ar3d/verify/certificate.h"

namespace ar3d::testing {

/// One for each effort.
inline const std::vector<compact_120::Options>& compact_120_modes() {
  static const std::vector<compact_120::Options> modes = {
      {.effort = 0}, {.effort = 1}, {.effort = 2}};
  return modes;
}

/// Empty if the drawing is proved right, has five bends on every edge and keeps the theorem's box
/// and that of its own strip; else what is wrong.
inline std::string compact_120_fault(const Graph& graph, const Drawing& drawing) {
  static const Algorithm row = compact_120::row();
  const CrossingTest test =
      graph.num_vertices() <= 100 ? CrossingTest::all_pairs : CrossingTest::automatic;
  const Certificate certificate = certify(graph, drawing, row.guarantee, {.crossing_test = test});
  if (!certificate.valid()) return certificate.violations[0].message;
  std::vector<Point> points;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    drawing.polyline(e, points);
    if (points.size() != 7) return "not five bends";
  }
  if (graph.num_vertices() == 0) return "";
  if (!drawing.instance_bound) return "no bound of its own";
  const auto extents = certificate.box.extents();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (extents[axis] > (*drawing.instance_bound)[axis]) return "passes the box of its strip";
  }
  if (!row.guarantee.bound.holds(*drawing.instance_bound, graph.num_vertices())) {
    return "the strip's box passes the theorem's";
  }
  return "";
}

inline std::string compact_120_fault(const Graph& graph, const compact_120::Options& options) {
  return compact_120_fault(graph, compact_120::draw(graph, options));
}

/// The drawing in the proof's zones with all cells tried in turn, without random ones.
inline Drawing draw_120_by_scans(const Graph& graph) {
  const compact_120::Order order = compact_120::moved_order(graph);
  const compact_120::Links links =
      compact_120::assign_arms(graph, order, compact_120::choose_owners(graph, order));
  compact_120::Census census;
  const compact_120::Strip strip =
      compact_120::fill_zones(compact_120::in_levels(graph, order), links, graph.num_edges(),
                              RandomStream(1), census, false);
  Drawing drawing = compact_120::lift(graph, strip);
  drawing.instance_bound = compact_120::box_of(strip.size());
  return drawing;
}

inline std::int64_t count_120(const Drawing& drawing, const std::string& name) {
  for (const Counter& c : drawing.counters) {
    if (c.name == name) return c.value;
  }
  return -1;
}

}  // namespace ar3d::testing
