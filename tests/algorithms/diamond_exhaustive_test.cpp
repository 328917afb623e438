// Every graph of maximum degree 4 with few vertices, in every mode.

#include <gtest/gtest.h>

#include "algorithms/diamond_support.h"
#include "support/graphs.h"

namespace ar3d {
namespace {

using testing::diamond_fault;
using testing::diamond_modes;

class EverySmallGraph : public ::testing::TestWithParam<int> {};

TEST_P(EverySmallGraph, IsCertifiedInEveryMode) {
  for (const Graph& graph : testing::geng("-D4 " + std::to_string(GetParam()))) {
    for (const DiamondOptions& options : diamond_modes()) {
      ASSERT_EQ(diamond_fault(graph, options), "")
          << "effort " << options.effort << " guaranteed " << options.guaranteed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpToNineVertices, EverySmallGraph, ::testing::Range(1, 10));

class EveryFourRegularGraph : public ::testing::TestWithParam<int> {};

TEST_P(EveryFourRegularGraph, IsCertifiedInFiveLabellings) {
  std::uint64_t seed = 0;
  for (const Graph& graph : testing::geng("-c -d4 -D4 " + std::to_string(GetParam()))) {
    for (int relabelling = 0; relabelling < 5; ++relabelling) {
      const Graph shuffled = testing::shuffled(graph, ++seed);
      for (const DiamondOptions& options : diamond_modes()) {
        ASSERT_EQ(diamond_fault(shuffled, options), "") << "seed " << seed;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpToTwelveVertices, EveryFourRegularGraph, ::testing::Range(5, 13));

}  // namespace
}  // namespace ar3d
