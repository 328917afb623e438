// Algorithm `grid-paper` on every graph of maximum degree 3 with at most 10 vertices and every
// connected cubic one with at most 14, under every setting and with random chordless cycles.
#include <fmt/format.h>

#include "algorithms/grid_paper_support.h"

namespace ar3d::testing {
namespace {

/// Every setting, and three of the choices of random cycles.
void expect_right_under_every_setting(const Graph& graph, CounterSums& sums) {
  for (const Options& options : all_grid_paper_options()) {
    ASSERT_EQ(grid_paper_fault(graph, options), "");
  }
  for (const std::uint64_t seed : {7u, 8u, 9u}) {
    for (const Options& options :
         {Options{}, Options{Spread::least, true}, Options{Spread::columns}}) {
      ASSERT_EQ(grid_paper_fault(graph, options, {.random_cycles = seed}, &sums), "");
    }
  }
}

TEST(GridPaperOnAllGraphs, UpToTenVerticesAreCertified) {
  CounterSums sums;
  std::size_t drawn = 0;
  for (int n = 1; n <= 10; ++n) {
    for (const Graph& graph : geng(fmt::format("-D3 {}", n))) {
      expect_right_under_every_setting(graph, sums);
      if (HasFatalFailure()) return;
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 1u + 2 + 4 + 11 + 23 + 62 + 150 + 424 + 1165 + 3547);
  for (const auto& [name, sum] : sums) EXPECT_GT(sum, 100) << name;
}

TEST(GridPaperOnAllGraphs, ConnectedCubicOnesUpToFourteenVerticesAreCertified) {
  CounterSums sums;
  std::size_t drawn = 0;
  for (int n = 4; n <= 14; n += 2) {
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      expect_right_under_every_setting(graph, sums);
      if (HasFatalFailure()) return;
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 1u + 2 + 5 + 19 + 85 + 509);
}

TEST(GridPaperOnAllGraphs, NoGraphSmallerThanTheSmallestNeedsARepair) {
  for (const auto& [name, switches, graph] : left_out_repairs()) {
    if (switches.random_cycles) continue;  // cycles differ from graph to graph
    for (Vertex n = 7; n < graph.num_vertices(); ++n) {
      for (const Graph& smaller : geng(fmt::format("-c -D3 {}", n))) {
        ASSERT_EQ(grid_paper_fault(smaller, {}, switches), "") << name << ' ' << n;
      }
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
