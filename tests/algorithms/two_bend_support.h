#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/two_bend/two_bend.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "support/graphs.h"

namespace ar3d::testing {

/// Edge list in one line, for messages about small graphs.
inline std::string edges_of(const Graph& graph) {
  std::string text = fmt::format("{}:", graph.num_vertices());
  for (const Edge e : graph.edges()) text += fmt::format(" {}-{}", e.u, e.v);
  return text;
}

/// Draws and expects a valid certificate; returns the drawing's counters.
inline std::vector<Counter> expect_certified(const Graph& graph,
                                             const two_bend::Options& options = {}) {
  try {
    const Drawing drawing = two_bend::draw(graph, options);
    const Certificate certificate = certify(graph, drawing, find_algorithm("two-bend").guarantee);
    EXPECT_TRUE(certificate.valid() && certificate.complete)
        << (certificate.valid() ? "incomplete" : certificate.violations[0].message) << "\n"
        << edges_of(graph);
    const auto extents = bounding_box(drawing).extents();
    const auto& box = options.force_safe_layout ? two_bend::kBox : two_bend::kOrdinaryBox;
    for (std::size_t axis = 0; axis < 3 && graph.num_vertices() > 0; ++axis)
      EXPECT_TRUE(box[axis].holds(extents[axis], graph.num_vertices())) << edges_of(graph);
    if (graph.num_vertices() > 0) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_LE(extents[axis], drawing.instance_bound.value()[axis]) << edges_of(graph);
    }
    return drawing.counters;
  } catch (const InternalError& error) {
    ADD_FAILURE() << error.what() << "\n" << edges_of(graph);
    return {};
  }
}

/// Every family of maximum degree 3, as given and with its vertices in random order.
inline void expect_families_certified(std::initializer_list<std::uint64_t> sizes) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    for (const std::uint64_t n : sizes) {
      SCOPED_TRACE(family.name);
      const Graph graph = generate(family, n, n);
      expect_certified(graph);
      expect_certified(shuffled(graph, n));
    }
  }
}

}  // namespace ar3d::testing
