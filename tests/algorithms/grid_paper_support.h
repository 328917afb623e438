#pragma once

// What the tests of algorithm `grid-paper` share.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/algorithms/grid_paper/grid_paper.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "support/counters.h"
#include "support/graphs.h"

namespace ar3d::testing {

using grid_paper::Options, grid_paper::Spread;

/// All combinations of options.
inline std::vector<Options> all_grid_paper_options() {
  std::vector<Options> all;
  for (const Spread spread : {Spread::columns, Spread::conditional, Spread::least}) {
    for (const bool needed_gap : {false, true}) {
      for (const bool any_cycle : {false, true}) all.push_back({spread, needed_gap, any_cycle});
    }
  }
  return all;
}

/// Draws and certifies. "" or the first violation or broken invariant. Adds the drawing's counters.
inline std::string grid_paper_fault(const Graph& graph, const Options& options = {},
                                    const grid_paper::RepairSwitches& repairs = {},
                                    CounterSums* sums = nullptr) {
  static const Guarantee guarantee = grid_paper::row().guarantee;
  try {
    const Drawing drawing = grid_paper::draw(graph, options, repairs);
    if (sums != nullptr) add_counters(drawing, *sums);
    const auto extents = bounding_box(drawing).extents();
    for (std::size_t axis = 0; axis < 3 && graph.num_vertices() > 0; ++axis) {
      const std::int64_t own = drawing.instance_bound.value()[axis];
      EXPECT_LE(extents[axis], own) << "the proof's own bound";
      EXPECT_TRUE(guarantee.bound.axes[axis].holds(own, graph.num_vertices()));
    }
    const Certificate certificate = certify(graph, drawing, guarantee);
    if (certificate.valid()) return "";
    return certificate.violations.empty() ? "incomplete" : certificate.violations[0].message;
  } catch (const InternalError& error) {
    return error.what();
  }
}

/// One repair left out, and the smallest connected graph, as `nauty-geng` labels it, that is drawn
/// wrong then.
struct LeftOutRepair {
  const char* name;
  grid_paper::RepairSwitches switches;
  Graph graph;
};

inline std::vector<LeftOutRepair> left_out_repairs() {
  return {
      {"k4", {.k4 = false}, complete(4)},
      {"turned", {.turned = false}, Graph(5, {{0, 3}, {0, 4}, {1, 3}, {2, 4}, {3, 4}})},
      {"spread",
       {.spread = false},
       Graph(6, {{0, 3}, {0, 4}, {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}})},
      {"left", {.left = false}, Graph(6, {{0, 2}, {0, 4}, {0, 5}, {1, 3}, {1, 5}, {2, 4}, {3, 5}})},
      {"own_heights",
       {.own_heights = false},
       Graph(10, {{0, 3},
                  {0, 6},
                  {0, 7},
                  {1, 4},
                  {1, 6},
                  {1, 9},
                  {2, 5},
                  {2, 7},
                  {2, 9},
                  {3, 6},
                  {3, 8},
                  {4, 7},
                  {4, 8},
                  {5, 8},
                  {5, 9}})},
      {"past_layer",
       {.past_layer = false, .random_cycles = 10},
       Graph(7, {{0, 3}, {0, 5}, {0, 6}, {1, 4}, {1, 5}, {1, 6}, {2, 4}, {3, 5}, {4, 6}})},
      {"cleared",
       {.cleared = false},
       Graph(6, {{0, 3}, {0, 4}, {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 4}, {3, 5}})},
      {"switch_late", {.switch_late = false}, Graph(5, {{0, 3}, {0, 4}, {1, 4}, {2, 4}})},
  };
}

}  // namespace ar3d::testing
