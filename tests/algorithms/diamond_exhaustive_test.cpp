// Every graph of maximum degree 4 with few vertices, in every mode.
#include <fmt/format.h>

#include "algorithms/diamond_colourings.h"
#include "algorithms/diamond_support.h"
#include "support/graphs.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

class EverySmallGraph : public ::testing::TestWithParam<int> {};

TEST_P(EverySmallGraph, IsCertifiedInEveryMode) {
  for (const Graph& graph : geng(fmt::format("-D4 {}", GetParam()))) {
    ASSERT_EQ(diamond_fault(graph), "");
  }
}

TEST(SmallGraphs, AreAll18745) {
  std::size_t count = 0;
  for (int n = 1; n <= 9; ++n) count += geng(fmt::format("-D4 {}", n)).size();
  EXPECT_EQ(count, 18745u);
}

INSTANTIATE_TEST_SUITE_P(UpToNineVertices, EverySmallGraph, ::testing::Range(1, 10), named("n"));

class EveryFourRegularGraph : public ::testing::TestWithParam<int> {};

TEST_P(EveryFourRegularGraph, IsCertifiedInFiveLabellings) {
  std::uint64_t seed = 0;
  for (const Graph& graph : geng(fmt::format("-c -d4 -D4 {}", GetParam()))) {
    for (int relabelling = 0; relabelling < 5; ++relabelling) {
      ASSERT_EQ(diamond_fault(shuffled(graph, ++seed)), "") << "seed " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpToTwelveVertices, EveryFourRegularGraph, ::testing::Range(5, 13),
                         named("n"));

// With diamond_long_test.cpp (n = 7) this is the part of the size bound's proof for n <= 7, see
// docs/theorem1.md.
TEST(GuaranteedMode, FitsOnEveryColouringOfAtMostSixVertices) {
  for (Vertex n = 1; n <= 6; ++n) {
    std::size_t colourings = 0;
    EXPECT_EQ(count_colouring_faults(n, colourings), 0u) << n << " vertices";
    EXPECT_GT(colourings, 0u);
  }
}

}  // namespace
}  // namespace ar3d::testing
