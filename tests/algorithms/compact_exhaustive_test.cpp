// Every graph of maximum degree 4 with few vertices, in narrow strips and in the proof's zones.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/compact_support.h"
#include "support/graphs.h"
#include "support/names.h"

namespace ar3d {
namespace {

using testing::compact_fault;

class CompactSmallGraphs : public ::testing::TestWithParam<int> {};

TEST_P(CompactSmallGraphs, AreCertifiedInEveryMode) {
  for (const Graph& graph : testing::geng(fmt::format("-D4 {}", GetParam()))) {
    for (const compact::Options& options : testing::compact_modes()) {
      ASSERT_EQ(compact_fault(graph, options), "") << "effort " << options.effort;
    }
  }
}

TEST_P(CompactSmallGraphs, AreCertifiedWithCellsTriedInTurn) {
  for (const Graph& graph : testing::geng(fmt::format("-D4 {}", GetParam()))) {
    ASSERT_EQ(compact_fault(graph, testing::draw_by_scans(graph)), "");
  }
}

INSTANTIATE_TEST_SUITE_P(UpToNineVertices, CompactSmallGraphs, ::testing::Range(1, 10),
                         testing::named("n"));

class CompactFourRegular : public ::testing::TestWithParam<int> {};

TEST_P(CompactFourRegular, AreCertifiedInThreeLabellings) {
  std::uint64_t seed = 0;
  for (const Graph& graph : testing::geng(fmt::format("-c -d4 -D4 {}", GetParam()))) {
    for (int relabelling = 0; relabelling < 3; ++relabelling) {
      const Graph shuffled = testing::shuffled(graph, ++seed);
      for (const compact::Options& options : testing::compact_modes()) {
        ASSERT_EQ(compact_fault(shuffled, options), "") << "seed " << seed;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpToElevenVertices, CompactFourRegular, ::testing::Range(5, 12),
                         testing::named("n"));

}  // namespace
}  // namespace ar3d
