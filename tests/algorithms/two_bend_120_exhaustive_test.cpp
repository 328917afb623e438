// Every cubic graph with up to 12 vertices: certified if it is 3-connected, else certified or refused.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "algorithms/two_bend_120_support.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

class TwoBend120Cubic : public ::testing::TestWithParam<int> {};

TEST_P(TwoBend120Cubic, AreDrawnIfTheyAre3Connected) {
  const std::map<int, std::pair<int, int>> counts = {
      {4, {1, 1}}, {6, {2, 2}}, {8, {4, 4}}, {10, {14, 15}}, {12, {57, 67}}};
  int connected = 0, drawn = 0;
  std::uint64_t seed = 0;
  for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", GetParam()))) {
    const bool is_connected = is_cubic_and_3_connected(graph);
    connected += is_connected ? 1 : 0;
    drawn += is_drawn_or_refused_120(graph, is_connected) ? 1 : 0;
    for (int i = 0; is_connected && i < 5; ++i) {
      ASSERT_EQ(two_bend_120_fault(shuffled(graph, ++seed)), "") << seed;
    }
  }
  EXPECT_EQ(std::pair(connected, drawn), counts.at(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(UpTo12Vertices, TwoBend120Cubic, ::testing::Values(4, 6, 8, 10, 12),
                         named("n"));

}  // namespace
}  // namespace ar3d::testing
