// Every graph of maximum degree 3 with few vertices and every connected cubic graph with up to 16,
// in narrow strips and in the proof's zones.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/compact_120_support.h"
#include "support/graphs.h"
#include "support/names.h"

namespace ar3d {
namespace {

using testing::compact_120_fault;

class Compact120SmallGraphs : public ::testing::TestWithParam<int> {};

TEST_P(Compact120SmallGraphs, AreCertifiedInEveryModeUnderTwoLabellings) {
  std::uint64_t seed = 0;
  for (const Graph& graph : testing::geng(fmt::format("-D3 {}", GetParam()))) {
    for (const Graph& labelled : {graph, testing::shuffled(graph, ++seed)}) {
      for (const compact_120::Options& options : testing::compact_120_modes()) {
        ASSERT_EQ(compact_120_fault(labelled, options), "")
            << "effort " << options.effort << " seed " << seed;
      }
    }
  }
}

TEST_P(Compact120SmallGraphs, AreCertifiedWithCellsTriedInTurn) {
  for (const Graph& graph : testing::geng(fmt::format("-D3 {}", GetParam()))) {
    ASSERT_EQ(compact_120_fault(graph, testing::draw_120_by_scans(graph)), "");
  }
}

INSTANTIATE_TEST_SUITE_P(UpToTenVertices, Compact120SmallGraphs, ::testing::Range(1, 11),
                         testing::named("n"));

class Compact120Cubic : public ::testing::TestWithParam<int> {};

TEST_P(Compact120Cubic, AreCertifiedInTwoLabellings) {
  std::uint64_t seed = 0;
  for (const Graph& graph : testing::geng(fmt::format("-c -d3 -D3 {}", GetParam()))) {
    for (int relabelling = 0; relabelling < 2; ++relabelling) {
      const Graph shuffled = testing::shuffled(graph, ++seed);
      for (const compact_120::Options& options : testing::compact_120_modes()) {
        ASSERT_EQ(compact_120_fault(shuffled, options), "")
            << "effort " << options.effort << " seed " << seed;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpToSixteenVertices, Compact120Cubic,
                         ::testing::Values(4, 6, 8, 10, 12, 14, 16), testing::named("n"));

}  // namespace
}  // namespace ar3d
