#pragma once

#include <string>
#include <vector>

#include "ar3d/algorithms/diamond/diamond.h"
#include "ar3d/verify/certificate.h"
#include "support/counters.h"

namespace ar3d::testing {

/// One for each effort.
inline const std::vector<diamond::Options>& diamond_modes() {
  static const std::vector<diamond::Options> modes = {{.effort = 0}, {.effort = 1}, {.effort = 2}};
  return modes;
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
  if (counter_of(drawing, "mode") == 0 &&
      counter_of(drawing, "H") > counter_of(drawing, "m_green") + counter_of(drawing, "rho") + 2) {
    return "H > m_green + rho + 2";
  }
  return "";
}

/// Likewise of all modes, naming the effort.
inline std::string diamond_fault(const Graph& graph) {
  for (const diamond::Options& options : diamond_modes()) {
    const std::string fault = diamond_fault(graph, diamond::draw(graph, options));
    if (!fault.empty()) return "effort " + std::to_string(options.effort) + ": " + fault;
  }
  return "";
}

}  // namespace ar3d::testing
