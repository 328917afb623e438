// `compact` and `compact-120`: all families of the catalogue, with their own labels and with
// others, and unions.
#include "algorithms/strips_support.h"
#include "ar3d/generators/catalog.h"
#include "support/names.h"

namespace ar3d::testing {
namespace {

struct FamiliesOfSize {
  const StripAlgorithm* algorithm;
  std::uint64_t n;
};
std::ostream& operator<<(std::ostream& out, const FamiliesOfSize& of) {
  return out << of.algorithm->suite << " n" << of.n;
}
std::vector<FamiliesOfSize> some_sizes() {
  std::vector<FamiliesOfSize> all;
  for (const StripAlgorithm* algorithm : {&compact_strips(), &compact_120_strips()}) {
    for (const std::uint64_t n : {4u, 12u, 40u, 150u, 600u}) all.push_back({algorithm, n});
  }
  return all;
}

class StripFamilies : public ::testing::TestWithParam<FamiliesOfSize> {};

TEST_P(StripFamilies, AreCertifiedAtEveryEffort) {
  const auto [algorithm, n] = GetParam();
  for (const Family& family : families()) {
    if (family.max_degree > algorithm->max_degree()) continue;
    for (const int shuffle : {0, 1}) {
      const Graph graph = generate(family, n, 7, {{"shuffle", shuffle}});
      EXPECT_EQ(strip_fault(*algorithm, graph), "") << family.name << " shuffle " << shuffle;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, StripFamilies, ::testing::ValuesIn(some_sizes()), named());

class StripInputs : public Strips {};

TEST_P(StripInputs, OfFiveThousandVerticesAreCertified) {
  for (const Family& family : families()) {
    const bool is_chosen = family.name == algorithm().regular ||
                           family.name == algorithm().small_union || family.name == "path" ||
                           family.name == "prism";
    if (!is_chosen) continue;
    const Graph graph = generate(family, 5000, 3);
    EXPECT_EQ(strip_fault(algorithm(), graph, algorithm().draw(graph, 1)), "") << family.name;
  }
}

TEST_P(StripInputs, ProofsZonesTriedInTurnAreCertified) {
  for (const Family& family : families()) {
    if (family.max_degree > algorithm().max_degree()) continue;
    const Graph graph = generate(family, 100, 5);
    const Drawing drawing = algorithm().draw_by_scans(graph);
    EXPECT_EQ(strip_fault(algorithm(), graph, drawing), "") << family.name;
    EXPECT_EQ(counter_of(drawing, "scans"), graph.num_vertices()) << family.name;
  }
}

TEST_P(StripInputs, UnionsOfManyKindsAreCertified) {
  std::vector<Graph> kinds = {Graph(1, {}), path(7), cycle(3), petersen(), complete(2)};
  kinds.insert(kinds.end(), algorithm().extremes.begin(), algorithm().extremes.end());
  std::vector<Graph> parts;
  for (int round = 0; round < 12; ++round) parts.insert(parts.end(), kinds.begin(), kinds.end());
  EXPECT_EQ(strip_fault(algorithm(), shuffled(disjoint_union(parts), 1)), "");
}

INSTANTIATE_TEST_SUITE_P(Of, StripInputs, kBothStripAlgorithms, kStripSuite);

}  // namespace
}  // namespace ar3d::testing
