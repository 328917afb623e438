#pragma once

#include <string>
#include <vector>

#include "ar3d/algorithms/compact/compact.h"
#include "ar3d/algorithms/compact/routes.h"
#include "ar3d/algorithms/compact/zones.h"
#include "ar3d/verify/certificate.h"

namespace ar3d::testing {

/// One for each effort.
inline const std::vector<compact::Options>& compact_modes() {
  static const std::vector<compact::Options> modes = {{.effort = 0}, {.effort = 1}, {.effort = 2}};
  return modes;
}

/// Empty if the drawing is proved right, has five bends on every edge and keeps the theorem's box
/// and that of its own strip; else what is wrong.
inline std::string compact_fault(const Graph& graph, const Drawing& drawing) {
  static const Algorithm row = compact::row();
  const CrossingTest test =
      graph.num_vertices() <= 200 ? CrossingTest::all_pairs : CrossingTest::automatic;
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

inline std::string compact_fault(const Graph& graph, const compact::Options& options) {
  return compact_fault(graph, compact::draw(graph, options));
}

/// The drawing in the proof's zones with all cells tried in turn, without random ones.
inline Drawing draw_by_scans(const Graph& graph) {
  const compact::Decomposition links = compact::decompose(graph);
  compact::Census census;
  const compact::Strip strip = compact::fill_zones(graph, links, RandomStream(1), census, false);
  Drawing drawing = compact::lift(graph, links, strip);
  drawing.instance_bound = compact::box_of(strip.size());
  return drawing;
}

inline std::int64_t count_of(const Drawing& drawing, const std::string& name) {
  for (const Counter& c : drawing.counters) {
    if (c.name == name) return c.value;
  }
  return -1;
}

}  // namespace ar3d::testing
