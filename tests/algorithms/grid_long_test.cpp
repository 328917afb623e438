// Algorithm `grid` on all graphs of maximum degree 3 with 12 and 13 vertices and all connected
// cubic graphs with at most 18, certified; and on long thin and defect-rich graphs.
#include <fmt/format.h>

#include <array>

#include "algorithms/grid_checks.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

TEST(GridLong, TwelveAndThirteenVertices) {
  std::size_t drawn = 0;
  for (const int n : {12, 13}) {
    for (const Graph& graph : geng(fmt::format("-D3 {}", n))) {
      for (const int effort : {0, 1}) ASSERT_EQ(grid_fault(graph, effort), "");
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 36327u + 124380u);
}

TEST(GridLong, ConnectedCubicGraphs) {
  std::array<CounterSums, 2> counts;  // by effort
  std::size_t drawn = 0;
  for (int n = 4; n <= 18; n += 2) {
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      for (const std::size_t effort : {0u, 1u}) {
        ASSERT_EQ(grid_fault(graph, static_cast<std::int64_t>(effort), &counts[effort]), "");
      }
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 1u + 2 + 5 + 19 + 85 + 509 + 4060 + 41301);
  expect_all_hit(counts[0]);
  EXPECT_GT(counts[1]["flat_defects"], 0);
  EXPECT_EQ(counts[1]["core_parts"], 0) << "flat numbers have worked for all of them so far";
}

TEST(GridLong, LargeFamilies) {
  for (const Family& family : families()) {
    const Graph graph = shuffled(generate(family, 10000, 5), 6);
    if (graph.max_degree() > 3) continue;
    for (const int effort : {0, 1}) {
      ASSERT_EQ(grid_fault(graph, effort), "") << family.name << " effort " << effort;
    }
  }
}

TEST(GridLong, HundredThousandVerticesOfHardFamilies) {
  for (const char* family : {"union-petersen", "union-flower-snark", "mixed-union", "cubic-tree",
                             "random-cubic-tree", "goldberg-snark", "spine-with-pendant-trees"}) {
    const Graph graph = shuffled(generate(find_family(family), 100000, 5), 6);
    for (const int effort : {0, 1}) {
      ASSERT_EQ(grid_fault(graph, effort), "") << family << " effort " << effort;
    }
  }
}

TEST(GridLong, TrianglesNestedAHundredThousandDeep) {
  const Graph graph = shuffled(nested_cubic_triangles(100000), 3);
  ASSERT_EQ(graph.max_degree(), 3u);
  for (const int effort : {0, 1}) ASSERT_EQ(grid_fault(graph, effort), "");
}

TEST(GridLong, AMillionVerticesOfARandomCubicGraph) {
  EXPECT_EQ(grid_fault(generate(find_family("random-cubic"), 1000000, 1), 1), "");
}

TEST(GridLong, SpineWithPendantTreesStaysLinear) {
  for (const std::uint64_t n : {10000u, 100000u}) {
    const Graph graph = generate(find_family("spine-with-pendant-trees"), n, 1);
    for (const int effort : {0, 1}) {
      const Drawing drawing = draw(find_algorithm("grid"), graph, {{"effort", effort}});
      for (const std::int64_t extent : bounding_box(drawing).extents()) {
        EXPECT_LE(extent, 20 * static_cast<std::int64_t>(n)) << "effort " << effort;
      }
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
