// Every graph of maximum degree 3 with at most 11 vertices, at every effort, certified.
#include <fmt/format.h>

#include "algorithms/grid_checks.h"
#include "ar3d/algorithms/catalog.h"
#include "support/graphs.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

class GridOnAllGraphs : public ::testing::TestWithParam<std::int64_t> {};

TEST_P(GridOnAllGraphs, UpToElevenVerticesAreCertified) {
  CounterSums counts;
  std::size_t drawn = 0;
  for (int n = 1; n <= 11; ++n) {
    for (const Graph& graph : geng(fmt::format("-D3 {}", n))) {
      ASSERT_EQ(grid_fault(graph, GetParam(), &counts), "") << "n = " << n;
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 16335u);
  if (GetParam() == 0) {
    expect_all_hit(counts);
  } else {
    EXPECT_GT(counts["flat_defects"], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Efforts, GridOnAllGraphs, ::testing::Values(0, 1), named("effort"));

}  // namespace
}  // namespace ar3d::testing
