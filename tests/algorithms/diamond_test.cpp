// The public function: corner cases, refusals, options, counters.
#include "ar3d/algorithms/diamond/diamond.h"

#include "algorithms/diamond_support.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

struct Named {
  const char* name;
  Graph graph;
};

std::vector<Named> corner_cases() {
  const Graph point(1, {});
  return {
      {"no vertices", Graph()},
      {"one vertex", point},
      {"edgeless", Graph(7, {})},
      {"K2", complete(2)},
      {"K2 and a point", disjoint_union({point, complete(2)})},
      {"path 3", path(3)},
      {"path 50", path(50)},
      {"triangle", cycle(3)},
      {"triangle, other way round", Graph(3, {{0, 2}, {2, 1}, {1, 0}})},
      {"cycle 4", cycle(4)},
      {"cycle 51", cycle(51)},
      {"K4", complete(4)},
      {"K5", complete(5)},
      {"K1,4", Graph(5, {{2, 0}, {2, 1}, {2, 3}, {2, 4}})},
      {"octahedron", octahedron()},
      {"Petersen", petersen()},
      {"points among cycles",
       disjoint_union({point, cycle(3), point, cycle(5), point, complete(5)})},
      {"many K2", disjoint_union(std::vector<Graph>(40, complete(2)))},
      {"many triangles", disjoint_union(std::vector<Graph>(30, cycle(3)))},
      {"many K4", disjoint_union(std::vector<Graph>(25, complete(4)))},
      {"many K5", disjoint_union(std::vector<Graph>(20, complete(5)))},
      {"many octahedra", disjoint_union(std::vector<Graph>(15, octahedron()))},
      {"squared cycle 7", squared_cycle(7)},
      {"squared cycle 101", squared_cycle(101)},
  };
}

TEST(Diamond, DrawsCornerCasesInEveryMode) {
  for (const auto& [name, graph] : corner_cases()) {
    EXPECT_EQ(diamond_fault(graph), "") << name;
  }
}

TEST(Diamond, EveryEdgeHasThreeBends) {
  const Graph graph = petersen();
  const Drawing drawing = diamond::draw(graph);
  std::vector<Point> points;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    drawing.polyline(e, points);
    EXPECT_EQ(points.size(), 5u);
  }
}

std::int64_t grid_points(const Drawing& drawing) {
  const auto [x, y, z] = bounding_box(drawing).extents();
  return (x + 1) * (y + 1) * (z + 1);
}

TEST(Diamond, TheHighestEffortIsNeverLarger) {
  for (const auto& [name, graph] : corner_cases()) {
    const std::int64_t two = grid_points(diamond::draw(graph, {.effort = 2}));
    EXPECT_LE(two, grid_points(diamond::draw(graph, {.effort = 1}))) << name;
    EXPECT_LE(two, grid_points(diamond::draw(graph, {.effort = 0}))) << name;
  }
}

TEST(Diamond, GuaranteedModeTellsItsGaps) {
  const Drawing drawing = diamond::draw(disjoint_union({complete(5), octahedron()}), {.effort = 0});
  EXPECT_EQ(counter_of(drawing, "mode"), 0);
  EXPECT_EQ(counter_of(drawing, "H"), counter_of(drawing, "green_gaps") +
                                          counter_of(drawing, "bumps") +
                                          counter_of(drawing, "offsets"));
  ASSERT_TRUE(drawing.instance_bound);
  EXPECT_EQ((*drawing.instance_bound)[0], 4 * 11 + 2 * counter_of(drawing, "H"));
  EXPECT_EQ((*drawing.instance_bound)[2], 6 * 11 + 3 * counter_of(drawing, "H") - 4);
}

TEST(Diamond, SmallerModesKeepTheBoundOfTheGuaranteedOne) {
  const Graph graph = squared_cycle(100);
  const Drawing proof = diamond::draw(graph, {.effort = 0});
  const Drawing smaller = diamond::draw(graph, {.effort = 2});
  ASSERT_NE(counter_of(smaller, "mode"), 0);
  ASSERT_TRUE(smaller.instance_bound);
  EXPECT_EQ(*smaller.instance_bound, *proof.instance_bound);
  EXPECT_EQ(counter_of(smaller, "H"), counter_of(proof, "H"));
}

TEST(Diamond, PairsBeatAlternatingParityOnManyTriangles) {
  // Squared cycles put a clash on every line of the alternating mode; pairs 0011 avoid them.
  const Drawing drawing = diamond::draw(squared_cycle(1000), {.effort = 2});
  EXPECT_EQ(counter_of(drawing, "mode"), 2);
}

}  // namespace
}  // namespace ar3d::testing
