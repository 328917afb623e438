// Every graph of maximum degree 4 with at most 9 vertices, and every connected 4-regular graph with
// at most 12.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <vector>

#include "algorithms/two_bend_109_support.h"
#include "support/graphs.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

/// How many there are of each size: 18,745 in all.
constexpr std::array<std::size_t, 10> kGraphs = {0, 1, 2, 4, 11, 34, 122, 510, 2590, 15471};

class TwoBend109SmallGraphs : public ::testing::TestWithParam<int> {};

TEST_P(TwoBend109SmallGraphs, AreCertifiedAtBothEfforts) {
  const std::vector<Graph> graphs = geng(fmt::format("-D4 {}", GetParam()));
  ASSERT_EQ(graphs.size(), kGraphs[static_cast<std::size_t>(GetParam())]);
  for (const Graph& graph : graphs) {
    for (const int effort : {0, 1}) {
      ASSERT_EQ(two_bend_109_fault(graph, {.effort = effort}), "") << "effort " << effort;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpToNineVertices, TwoBend109SmallGraphs, ::testing::Range(1, 10),
                         named("n"));

class TwoBend109Regular : public ::testing::TestWithParam<int> {};

TEST_P(TwoBend109Regular, AreCertifiedUnderThreeLabellings) {
  const std::map<int, std::size_t> counts = {{5, 1},  {6, 1},   {7, 2},    {8, 6},
                                             {9, 16}, {10, 59}, {11, 265}, {12, 1544}};
  const std::vector<Graph> graphs = geng(fmt::format("-c -d4 -D4 {}", GetParam()));
  ASSERT_EQ(graphs.size(), counts.at(GetParam()));
  std::uint64_t seed = 0;
  for (const Graph& graph : graphs) {
    for (const int effort : {0, 1}) {
      ASSERT_EQ(two_bend_109_fault(graph, {.effort = effort}), "") << "effort " << effort;
      for (int relabelling = 0; relabelling < 2; ++relabelling) {
        const Graph relabelled = shuffled(graph, ++seed);
        ASSERT_EQ(two_bend_109_fault(relabelled, {.effort = effort}), "") << "seed " << seed;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpToTwelveVertices, TwoBend109Regular, ::testing::Range(5, 13),
                         named("n"));

}  // namespace
}  // namespace ar3d::testing
