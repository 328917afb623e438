// Every graph of maximum degree 4 with at most 8 vertices and every cubic one with at most 14, with
// each number of bends; every family; random graphs.
#include "algorithms/routed_support.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

class RoutedOnAllGraphs : public ::testing::TestWithParam<std::int64_t> {};

TEST_P(RoutedOnAllGraphs, OfDegreeFourToEightVerticesAreRouted) {
  int fall_backs = 0;
  for (int n = 1; n <= 8; ++n) {
    for (const Graph& graph : geng("-D4 " + std::to_string(n))) {
      ASSERT_EQ(routed_fault(graph, routed::row_109(), GetParam(), 0, &fall_backs), "") << n;
    }
  }
  EXPECT_EQ(fall_backs, 0);
}

TEST_P(RoutedOnAllGraphs, CubicToFourteenVerticesAreRouted) {
  int fall_backs = 0;
  for (int n = 4; n <= 14; n += 2) {
    for (const Graph& graph : geng("-c -d3 -D3 " + std::to_string(n))) {
      ASSERT_EQ(routed_fault(graph, routed::row_120(), GetParam(), 0, &fall_backs), "") << n;
    }
  }
  EXPECT_EQ(fall_backs, 0);
}

TEST_P(RoutedOnAllGraphs, FamiliesOfAHundredAndAThousandVerticesAreCertified) {
  for (const Family& family : families()) {
    for (const std::uint64_t n : {100u, 1000u}) {
      const Graph graph = generate(family, n, 1);
      if (graph.max_degree() <= 4) {
        EXPECT_EQ(routed_fault(graph, routed::row_109(), GetParam(), 0), "") << family.name << n;
      }
      if (graph.max_degree() <= 3) {
        EXPECT_EQ(routed_fault(graph, routed::row_120(), GetParam(), 0), "") << family.name << n;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bends, RoutedOnAllGraphs, ::testing::Values(3, 4, 5), named("bends"));

}  // namespace
}  // namespace ar3d::testing
