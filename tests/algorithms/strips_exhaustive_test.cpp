// `compact` and `compact-120` on every graph of their degree with few vertices and every connected
// regular one with some more, in narrow strips and in the proof's zones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/strips_support.h"
#include "support/names.h"

namespace ar3d {
namespace {

using testing::strip_fault;
using testing::StripAlgorithm;

struct GraphsOfSize {
  const StripAlgorithm* algorithm;
  int n;
};
std::ostream& operator<<(std::ostream& out, const GraphsOfSize& of) {
  return out << of.algorithm->suite << " n" << of.n;
}
std::vector<GraphsOfSize> with_sizes(const StripAlgorithm& algorithm, int first, int last,
                                     int step) {
  std::vector<GraphsOfSize> all;
  for (int n = first; n <= last; n += step) all.push_back({&algorithm, n});
  return all;
}

class StripSmallGraphs : public ::testing::TestWithParam<GraphsOfSize> {};

TEST_P(StripSmallGraphs, AreCertifiedAtEveryEffortUnderTwoLabellings) {
  const auto [algorithm, n] = GetParam();
  std::uint64_t seed = 0;
  for (const Graph& graph : testing::geng(fmt::format("-D{} {}", algorithm->max_degree(), n))) {
    ASSERT_EQ(strip_fault(*algorithm, graph), "");
    ASSERT_EQ(strip_fault(*algorithm, testing::shuffled(graph, ++seed)), "") << "seed " << seed;
  }
}

TEST_P(StripSmallGraphs, AreCertifiedWithCellsTriedInTurn) {
  const auto [algorithm, n] = GetParam();
  for (const Graph& graph : testing::geng(fmt::format("-D{} {}", algorithm->max_degree(), n))) {
    ASSERT_EQ(strip_fault(*algorithm, graph, algorithm->draw_by_scans(graph)), "");
  }
}

INSTANTIATE_TEST_SUITE_P(UpToNineVertices, StripSmallGraphs,
                         ::testing::ValuesIn(with_sizes(testing::compact_strips(), 1, 9, 1)),
                         testing::named());
INSTANTIATE_TEST_SUITE_P(UpToTenVertices, StripSmallGraphs,
                         ::testing::ValuesIn(with_sizes(testing::compact_120_strips(), 1, 10, 1)),
                         testing::named());

class StripRegularGraphs : public ::testing::TestWithParam<GraphsOfSize> {};

TEST_P(StripRegularGraphs, AreCertifiedInThreeLabellings) {
  const auto [algorithm, n] = GetParam();
  std::uint64_t seed = 0;
  for (const Graph& graph :
       testing::geng(fmt::format("-c -d{0} -D{0} {1}", algorithm->max_degree(), n))) {
    for (int relabelling = 0; relabelling < 3; ++relabelling) {
      ASSERT_EQ(strip_fault(*algorithm, testing::shuffled(graph, ++seed)), "") << "seed " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpToElevenVertices, StripRegularGraphs,
                         ::testing::ValuesIn(with_sizes(testing::compact_strips(), 5, 11, 1)),
                         testing::named());
INSTANTIATE_TEST_SUITE_P(UpToSixteenVertices, StripRegularGraphs,
                         ::testing::ValuesIn(with_sizes(testing::compact_120_strips(), 4, 16, 2)),
                         testing::named());

}  // namespace
}  // namespace ar3d
