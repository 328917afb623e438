// Every 3-connected cubic graph with 14 and 16 vertices, and large ones: certified.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

#include "algorithms/two_bend_120_support.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::testing {
namespace {

TEST(TwoBend120Long, Every3ConnectedCubicGraphWith14And16Vertices) {
  std::uint64_t seed = 0;
  for (const auto& [n, expected] : {std::pair{14, std::pair{341, 427}}, {16, {2828, 3616}}}) {
    int connected = 0, drawn = 0;
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      const bool is_connected = is_cubic_and_3_connected(graph);
      connected += is_connected ? 1 : 0;
      drawn += is_drawn_or_refused_120(graph, is_connected) ? 1 : 0;
      for (int i = 0; is_connected && i < 5; ++i) {
        ASSERT_EQ(two_bend_120_fault(shuffled(graph, ++seed)), "") << seed;
      }
    }
    EXPECT_EQ(std::pair(connected, drawn), expected);
  }
}

TEST(TwoBend120Long, LargeGraphsOfSixFamilies) {
  for (const char* family : {"random-cubic", "flower-snark", "goldberg-snark", "blanusa-snark",
                             "moebius-ladder", "prism"}) {
    for (const std::uint64_t n : {1000u, 10000u, 30000u}) {
      const Graph graph = shuffled(generate(find_family(family), n, 5), n);
      EXPECT_EQ(two_bend_120_fault(graph), "") << family << ' ' << n;
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
