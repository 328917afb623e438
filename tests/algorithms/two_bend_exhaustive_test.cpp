// All three algorithms of two bends on every small graph that they draw.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <vector>

#include "algorithms/two_bend_109_support.h"
#include "algorithms/two_bend_paper_support.h"
#include "algorithms/two_bend_support.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

class TwoBendExhaustive : public ::testing::TestWithParam<int> {};

/// Every graph of maximum degree 3 with n vertices, as given and relabelled, ordinary and safe.
TEST_P(TwoBendExhaustive, CertifiesEveryGraphOfMaximumDegree3) {
  const int n = GetParam();
  std::uint64_t seed = 0;
  for (const Graph& graph : geng(fmt::format("-D3 {}", n))) {
    expect_certified(graph);
    expect_certified(graph, {.force_safe_layout = true});
    for (int i = 0; i < 5; ++i) expect_certified(shuffled(graph, ++seed));
    expect_certified(graph, {.effort = 0});
    if (HasFailure()) break;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, TwoBendExhaustive, ::testing::Range(1, 12), named("n"));

/// How many there are of each size: 18,745 in all.
constexpr std::array<std::size_t, 10> kGraphs = {0, 1, 2, 4, 11, 34, 122, 510, 2590, 15471};

/// Every graph at both efforts, as given and relabelled.
void expect_109(const std::vector<Graph>& graphs, int relabellings) {
  std::uint64_t seed = 0;
  for (const Graph& graph : graphs) {
    for (const int effort : {0, 1}) {
      ASSERT_EQ(two_bend_109_fault(graph, {.effort = effort}), "") << "effort " << effort;
      for (int relabelling = 0; relabelling < relabellings; ++relabelling) {
        const Graph relabelled = shuffled(graph, ++seed);
        ASSERT_EQ(two_bend_109_fault(relabelled, {.effort = effort}), "") << "seed " << seed;
      }
    }
  }
}

class TwoBend109SmallGraphs : public ::testing::TestWithParam<int> {};

TEST_P(TwoBend109SmallGraphs, AreCertifiedAtBothEfforts) {
  const std::vector<Graph> graphs = geng(fmt::format("-D4 {}", GetParam()));
  ASSERT_EQ(graphs.size(), kGraphs.at(static_cast<std::size_t>(GetParam())));
  expect_109(graphs, 0);
}

INSTANTIATE_TEST_SUITE_P(UpToNineVertices, TwoBend109SmallGraphs, ::testing::Range(1, 10),
                         named("n"));

class TwoBend109Regular : public ::testing::TestWithParam<int> {};

TEST_P(TwoBend109Regular, AreCertifiedUnderThreeLabellings) {
  const std::map<int, std::size_t> counts = {{5, 1},  {6, 1},   {7, 2},    {8, 6},
                                             {9, 16}, {10, 59}, {11, 265}, {12, 1544}};
  const std::vector<Graph> graphs = geng(fmt::format("-c -d4 -D4 {}", GetParam()));
  ASSERT_EQ(graphs.size(), counts.at(GetParam()));
  expect_109(graphs, 2);
}

INSTANTIATE_TEST_SUITE_P(UpToTwelveVertices, TwoBend109Regular, ::testing::Range(5, 13),
                         named("n"));

class TwoBendPaperExhaustive : public ::testing::TestWithParam<int> {};

TEST_P(TwoBendPaperExhaustive, EveryGraphOfMaximumDegree3) {
  std::uint64_t seed = 0;
  for (const Graph& graph : geng(fmt::format("-D3 {}", GetParam()))) {
    expect_right_in_reference(graph);
    expect_right_in_reference(shuffled(graph, ++seed));
    if (HasFailure()) break;
  }
}
INSTANTIATE_TEST_SUITE_P(Sizes, TwoBendPaperExhaustive, ::testing::Range(1, 10), named("n"));

TEST(TwoBendPaperExhaustive, ConnectedCubicGraphsUpTo14) {
  for (int n = 4; n <= 14; n += 2) {
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      expect_right_in_reference(graph);
      if (HasFailure()) return;
    }
  }
}

TEST(TwoBendPaperExhaustive, RandomCubicGraphsUpTo2000) {
  for (const std::uint64_t n : {500, 1000, 2000}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      expect_right_in_reference(generate(find_family("random-cubic"), n, seed));
    }
  }
}

TEST(TwoBendPaperExhaustive, RandomMixturesOfFigures) {
  expect_mixtures_right(1500, RandomStream(4), 10, 24);
}

TEST(TwoBendPaperExhaustive, LongCyclesPrismsAndManyComponents) {
  for (const char* name : {"cycle", "prism", "union-k4", "mixed-union", "path", "edgeless"}) {
    expect_right_in_reference(generate(find_family(name), 1200, 1), name);
  }
}

}  // namespace
}  // namespace ar3d::testing
