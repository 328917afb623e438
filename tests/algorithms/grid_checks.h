#pragma once

// What the tests of algorithm `grid` share.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/verify/certificate.h"

namespace ar3d::testing {

/// How often each case of the construction was used.
struct CaseCounts {
  std::int64_t nt = 0;
  std::int64_t pq = 0;
  std::int64_t last_u = 0;
  std::int64_t last_m = 0;
  std::int64_t last_p = 0;
  std::int64_t flat_defects = 0;
  std::int64_t core_parts = 0;

  /// The core must have used both clash rules and all three cases of the last edge.
  void expect_all_hit() const {
    EXPECT_GT(nt, 0);
    EXPECT_GT(pq, 0);
    EXPECT_GT(last_u, 0);
    EXPECT_GT(last_m, 0);
    EXPECT_GT(last_p, 0);
  }
};

inline std::int64_t counter(const Drawing& drawing, std::string_view name) {
  for (const Counter& counter : drawing.counters) {
    if (counter.name == name) return counter.value;
  }
  ADD_FAILURE() << "no counter " << name;
  return 0;
}

/// Draws and certifies. "" or the first violation; small graphs with their edges.
inline std::string grid_fault(const Graph& graph, std::int64_t effort,
                              CaseCounts* counts = nullptr) {
  const Algorithm& grid = find_algorithm("grid");
  const Drawing drawing = draw(grid, graph, {{"effort", effort}});
  if (counts != nullptr) {
    counts->nt += counter(drawing, "nt");
    counts->pq += counter(drawing, "pq");
    counts->last_u += counter(drawing, "last_u");
    counts->last_m += counter(drawing, "last_m");
    counts->last_p += counter(drawing, "last_p");
    counts->flat_defects += counter(drawing, "flat_defects");
    counts->core_parts += counter(drawing, "core_parts");
  }
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

}  // namespace ar3d::testing
