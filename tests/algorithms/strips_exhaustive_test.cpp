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
/// @param most_compact, most_120  the largest sizes.
std::vector<GraphsOfSize> with_sizes(int first, int most_compact, int most_120) {
  std::vector<GraphsOfSize> all;
  for (int n = first; n <= most_compact; ++n) all.push_back({&compact_strips(), n});
  for (int n = first; n <= most_120; ++n) all.push_back({&compact_120_strips(), n});
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

class StripSmallGraphs : public ::testing::TestWithParam<GraphsOfSize> {};

TEST_P(StripSmallGraphs, AreCertifiedAtEveryEffortUnderTwoLabellingsAndWithCellsTriedInTurn) {
  const auto [algorithm, n] = GetParam();
  std::uint64_t seed = 0;
  const std::vector<Graph> graphs = geng(fmt::format("-D{} {}", algorithm->max_degree(), n));
  EXPECT_EQ(graphs.size(), kSmall.at(algorithm->max_degree()).at(static_cast<std::size_t>(n)));
  for (const Graph& graph : graphs) {
    ASSERT_EQ(strip_fault(*algorithm, graph), "");
    ASSERT_EQ(strip_fault(*algorithm, shuffled(graph, ++seed)), "") << "seed " << seed;
    ASSERT_EQ(strip_fault(*algorithm, graph, algorithm->draw_by_scans(graph)), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Of, StripSmallGraphs, ::testing::ValuesIn(with_sizes(1, 9, 10)), named());

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

std::vector<GraphsOfSize> regular_sizes() {
  std::vector<GraphsOfSize> all = with_sizes(4, 11, 16);
  std::erase_if(all, [](const GraphsOfSize& of) {
    return !kRegular.at(of.algorithm->max_degree()).contains(of.n);
  });
  return all;
}

INSTANTIATE_TEST_SUITE_P(Of, StripRegularGraphs, ::testing::ValuesIn(regular_sizes()), named());

}  // namespace
}  // namespace ar3d::testing
