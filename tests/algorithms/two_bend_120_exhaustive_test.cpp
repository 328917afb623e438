// Every cubic graph with up to 12 vertices: drawn and certified iff it is 3-connected.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "algorithms/two_bend_120_support.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

class TwoBend120Cubic : public ::testing::TestWithParam<int> {};

TEST_P(TwoBend120Cubic, AreDrawnIfAndOnlyIfTheyAre3Connected) {
  const std::map<int, int> counts = {{4, 1}, {6, 2}, {8, 4}, {10, 14}, {12, 57}};
  int drawn = 0;
  std::uint64_t seed = 0;
  for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", GetParam()))) {
    const bool draws = is_cubic_and_3_connected(graph);
    drawn += draws ? 1 : 0;
    ASSERT_EQ(two_bend_120_fault(graph).empty(), draws) << two_bend_120_fault(graph);
    for (int i = 0; draws && i < 5; ++i) {
      ASSERT_EQ(two_bend_120_fault(shuffled(graph, ++seed)), "") << seed;
    }
  }
  EXPECT_EQ(drawn, counts.at(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(UpTo12Vertices, TwoBend120Cubic, ::testing::Values(4, 6, 8, 10, 12),
                         named("n"));

}  // namespace
}  // namespace ar3d::testing
