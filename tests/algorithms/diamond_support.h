#pragma once

#include <string>
#include <vector>

#include "ar3d/algorithms/diamond/diamond.h"
#include "ar3d/verify/certificate.h"

namespace ar3d::testing {

/// One for each effort.
inline const std::vector<diamond::Options>& diamond_modes() {
  static const std::vector<diamond::Options> modes = {{.effort = 0}, {.effort = 1}, {.effort = 2}};
  return modes;
}

/// The counter's value; -1 if the drawing has no such counter.
inline std::int64_t counter(const Drawing& drawing, const std::string& name) {
  for (const Counter& c : drawing.counters) {
    if (c.name == name) return c.value;
  }
  return -1;
}

/// Empty if the drawing is proved right, keeps the theorem's box and, where it claims one, the box
/// of its own proof; else what is wrong.
inline std::string diamond_fault(const Graph& graph, const Drawing& drawing) {
  static const Algorithm row = diamond::row();
  const Certificate certificate =
      certify(graph, drawing, row.guarantee, {.crossing_test = CrossingTest::all_pairs});
  if (!certificate.valid()) return certificate.violations[0].message;
  if (!drawing.instance_bound) return "";
  const auto extents = certificate.box.extents();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (extents[axis] > (*drawing.instance_bound)[axis]) return "wider than the proof's own bound";
  }
  if (counter(drawing, "mode") == 0 &&
      counter(drawing, "H") > counter(drawing, "m_green") + counter(drawing, "rho") + 2) {
    return "H > m_green + rho + 2";
  }
  return "";
}

inline std::string diamond_fault(const Graph& graph, const diamond::Options& options) {
  return diamond_fault(graph, diamond::draw(graph, options));
}

}  // namespace ar3d::testing
