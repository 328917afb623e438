// `compact` and `compact-120` on every graph of their degree with few vertices and every connected
// regular one with some more, in narrow strips and in the proof's zones.
#include <fmt/format.h>

#include <map>

#include "algorithms/strips_support.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

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

/// How many graphs with n vertices there are, by maximum degree.
const std::map<std::uint32_t, std::vector<std::size_t>> kSmall = {
    {3, {0, 1, 2, 4, 11, 23, 62, 150, 424, 1165, 3547}},
    {4, {0, 1, 2, 4, 11, 34, 122, 510, 2590, 15471}}};
/// How many connected regular ones, by degree.
const std::map<std::uint32_t, std::map<int, std::size_t>> kRegular = {
    {3, {{4, 1}, {6, 2}, {8, 5}, {10, 19}, {12, 85}, {14, 509}, {16, 4060}}},
    {4, {{5, 1}, {6, 1}, {7, 2}, {8, 6}, {9, 16}, {10, 59}, {11, 265}}}};

/// All of them, whose number is right.
std::vector<Graph> small_graphs(const StripAlgorithm& algorithm, int n) {
  std::vector<Graph> graphs = geng(fmt::format("-D{} {}", algorithm.max_degree(), n));
  EXPECT_EQ(graphs.size(), kSmall.at(algorithm.max_degree()).at(static_cast<std::size_t>(n)));
  return graphs;
}

class StripSmallGraphs : public ::testing::TestWithParam<GraphsOfSize> {};

TEST_P(StripSmallGraphs, AreCertifiedAtEveryEffortUnderTwoLabellings) {
  const auto [algorithm, n] = GetParam();
  std::uint64_t seed = 0;
  for (const Graph& graph : small_graphs(*algorithm, n)) {
    ASSERT_EQ(strip_fault(*algorithm, graph), "");
    ASSERT_EQ(strip_fault(*algorithm, shuffled(graph, ++seed)), "") << "seed " << seed;
  }
}

TEST_P(StripSmallGraphs, AreCertifiedWithCellsTriedInTurn) {
  const auto [algorithm, n] = GetParam();
  for (const Graph& graph : small_graphs(*algorithm, n)) {
    ASSERT_EQ(strip_fault(*algorithm, graph, algorithm->draw_by_scans(graph)), "");
  }
}

INSTANTIATE_TEST_SUITE_P(UpToNineVertices, StripSmallGraphs,
                         ::testing::ValuesIn(with_sizes(compact_strips(), 1, 9, 1)), named());
INSTANTIATE_TEST_SUITE_P(UpToTenVertices, StripSmallGraphs,
                         ::testing::ValuesIn(with_sizes(compact_120_strips(), 1, 10, 1)), named());

class StripRegularGraphs : public ::testing::TestWithParam<GraphsOfSize> {};

TEST_P(StripRegularGraphs, AreCertifiedInThreeLabellings) {
  const auto [algorithm, n] = GetParam();
  std::uint64_t seed = 0;
  const std::vector<Graph> graphs =
      geng(fmt::format("-c -d{0} -D{0} {1}", algorithm->max_degree(), n));
  EXPECT_EQ(graphs.size(), kRegular.at(algorithm->max_degree()).at(n));
  for (const Graph& graph : graphs) {
    for (int relabelling = 0; relabelling < 3; ++relabelling) {
      ASSERT_EQ(strip_fault(*algorithm, shuffled(graph, ++seed)), "") << "seed " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(UpToElevenVertices, StripRegularGraphs,
                         ::testing::ValuesIn(with_sizes(compact_strips(), 5, 11, 1)), named());
INSTANTIATE_TEST_SUITE_P(UpToSixteenVertices, StripRegularGraphs,
                         ::testing::ValuesIn(with_sizes(compact_120_strips(), 4, 16, 2)), named());

}  // namespace
}  // namespace ar3d::testing
