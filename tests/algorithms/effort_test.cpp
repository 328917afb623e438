// One scale of effort for all algorithms.
#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/efforts.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

TEST(Effort, IsTheOptionOfEveryProvedAlgorithmWithOneDefault) {
  for (const Algorithm* row : proved_algorithms()) {
    const Algorithm& algorithm = *row;
    ASSERT_EQ(algorithm.options.size(), 1u) << algorithm.name;
    const SettingSpec& effort = algorithm.options[0];
    EXPECT_EQ(effort.name, "effort") << algorithm.name;
    EXPECT_EQ(effort.default_value, kDefaultEffort) << algorithm.name;
    EXPECT_EQ(effort.low, 0) << algorithm.name;
    EXPECT_THAT(effort.high, AnyOf(1, 2)) << algorithm.name;
  }
}

TEST(Effort, OutsideTheScaleIsRefusedByName) {
  for (const Algorithm* row : proved_algorithms()) {
    const Algorithm& algorithm = *row;
    const Graph graph = path(3);
    for (const std::int64_t effort : {std::int64_t{-1}, algorithm.options[0].high + 1}) {
      EXPECT_THROW(draw(algorithm, graph, {{"effort", effort}}), InputError) << algorithm.name;
      EXPECT_THROW(algorithm.draw(graph, {{"effort", effort}}), InputError)
          << algorithm.name << ": the library's function checks, too";
    }
  }
  EXPECT_THROW(check_effort("x", 3, 2), InputError);
  EXPECT_NO_THROW(check_effort("x", 2, 2));
}

TEST(Effort, EveryOneDrawsTheSameGraphTheSameWayAndKeepsTheGuarantee) {
  for (const Algorithm* row : proved_algorithms()) {
    const Graph graph = row->guarantee.max_degree == 3 ? petersen() : squared_cycle(60);
    for (std::int64_t effort = 0; effort <= row->options[0].high; ++effort) {
      const Drawing one = draw(*row, graph, {{"effort", effort}});
      const Drawing two = draw(*row, graph, {{"effort", effort}});
      EXPECT_EQ(drawing_hash(one), drawing_hash(two)) << row->name << effort;
      EXPECT_EQ(one.counters, two.counters) << row->name << effort;
      EXPECT_EQ(one.algorithm(), row->name);
      EXPECT_TRUE(certify(graph, one, row->guarantee).valid()) << row->name << effort;
    }
  }
}

/// By effort, the volume of the box.
std::vector<Volume> volumes(const Algorithm& algorithm, const Graph& graph) {
  std::vector<Volume> all;
  for (std::int64_t effort = 0; effort <= algorithm.options[0].high; ++effort) {
    const Drawing drawing = draw(algorithm, graph, {{"effort", effort}});
    all.push_back(volume_of(bounding_box(drawing).extents()));
  }
  return all;
}

void expect_no_growth(const Algorithm& algorithm, const Graph& graph, const std::string& what) {
  const std::vector<Volume> all = volumes(algorithm, graph);
  EXPECT_TRUE(std::is_sorted(all.rbegin(), all.rend())) << algorithm.name << " on " << what;
}

bool fits(const Algorithm& algorithm, const Graph& graph) {
  return graph.max_degree() <= algorithm.guarantee.max_degree;
}

TEST(Effort, NeverDrawsALargerBoxThanALowerOneOfASmallGraph) {
  std::size_t graphs = 0;
  for (const int n : {1, 2, 3, 4, 5, 6, 7}) {
    for (const Graph& graph : geng("-D4 " + std::to_string(n))) {
      ++graphs;
      for (const Algorithm* row : proved_algorithms()) {
        if (fits(*row, graph)) {
          expect_no_growth(*row, graph, std::to_string(n) + " " + std::to_string(graphs));
        }
      }
    }
  }
  EXPECT_EQ(graphs, 684u);
}

TEST(Effort, NeverDrawsALargerBoxThanALowerOneOfAFamily) {
  for (const Family& family : families()) {
    for (const std::uint64_t n : {9u, 24u, 100u, 700u}) {
      for (const int shuffle : {0, 1}) {
        const Graph graph = generate(family, n, 3, {{"shuffle", shuffle}});
        for (const Algorithm* row : proved_algorithms()) {
          if (fits(*row, graph)) expect_no_growth(*row, graph, family.name);
        }
      }
    }
  }
}

TEST(Effort, OfRoutedDrawingsNeverDrawsALargerBoxThanALowerOne) {
  for (const char* name : {"routed", "routed-120"}) {
    const Algorithm& row = find_algorithm(name);
    for (const Graph& graph : geng("-D4 3")) expect_no_growth(row, graph, "three vertices");
  }
}

TEST(Effort, OneKeepsTheProofsDrawingOfAPathUpToTheLimitOnly) {
  const Algorithm& diamond = find_algorithm("diamond");
  const auto shares = [&](std::uint64_t n) {
    const std::vector<Volume> all = volumes(diamond, path(static_cast<Vertex>(n)));
    return static_cast<double>(all[1]) / static_cast<double>(all[0]);
  };
  EXPECT_EQ(shares(kMostCompared), 1);
  EXPECT_GT(shares(kMostCompared + 1), 100);
}

}  // namespace
}  // namespace ar3d::testing
