// What is needed: each rule broken, and what then goes wrong.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "algorithms/two_bend_109_support.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/algorithms/two_bend_109/placement.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::two_bend_109 {
namespace {

struct Stages {
  Graph graph;
  std::vector<VertexPart> parts;
  SlotArrangement arrangement;
  Layout layout;
};

Stages stages_of(const Graph& graph) {
  Stages s{graph, find_partition(graph), {}, {}};
  s.arrangement = arrange(graph, s.parts);
  s.layout = lay_out(graph, s.parts, s.arrangement, {16});
  return s;
}

std::optional<Placement> placed(const Stages& s) {
  return place(s.graph, s.parts, s.arrangement, s.layout, 1);
}

Graph random_graph() { return generate(find_family("random-4-regular"), 60, 3); }

TEST(TwoBend109Mutation, UnbrokenItIsPlaced) { EXPECT_TRUE(placed(stages_of(random_graph()))); }

TEST(TwoBend109Mutation, LowerHeightsTurnTooMuch) {
  Stages s = stages_of(random_graph());
  for (Point& p : s.layout.place) p.z /= 8;
  EXPECT_THROW(placed(s), InternalError);
}

TEST(TwoBend109Mutation, NarrowSlotsTurnTooMuch) {
  Stages s = stages_of(random_graph());
  for (Point& p : s.layout.place) p.x /= 40;
  EXPECT_THROW(placed(s), InternalError);
}

TEST(TwoBend109Mutation, PairsWithoutAGapTurnTooMuch) {
  Stages s = stages_of(random_graph());
  for (Point& p : s.layout.place) p.y = 0;
  EXPECT_THROW(placed(s), InternalError);
}

TEST(TwoBend109Mutation, ThreeDownMustStandBetweenItsNeighbours) {
  Stages s = stages_of(random_graph());
  for (Vertex v = 0; v < s.graph.num_vertices(); ++v) {
    if (s.arrangement.stubs[v].ends[0] == Vector{0, 0, 3}) s.layout.place[v].x += 10'000'000;
  }
  EXPECT_THROW(placed(s), InternalError);
}

TEST(TwoBend109Mutation, ThreeDownNeedsItsLoneStubOnTheSideOfOne) {
  Stages s = stages_of(random_graph());
  for (Stubs& stubs : s.arrangement.stubs) {
    if (stubs.ends[0] == Vector{0, 0, 3}) stubs = mirrored(stubs, true, false);
  }
  EXPECT_THROW(placed(s), InternalError);
}

TEST(TwoBend109Mutation, CornersOfACycleNeedTheirOwnStance) {
  Stages s = stages_of(testing::cycle(8));
  for (Vertex v = 0; v < 8; ++v) {
    if (s.arrangement.spot[v] == SlotSpot::lower)
      s.arrangement.stubs[v] = stubs_of(Stance::chain, 0);
  }
  EXPECT_THROW(placed(s), InternalError);
}

// The verifier sees what the construction must not do.
TEST(TwoBend109Mutation, AMovedBendIsFound) {
  const Graph graph = testing::octahedron();
  const Drawing drawing = draw(graph);
  std::vector<Point> points;
  for (EdgeId moved = 0; moved < graph.num_edges(); ++moved) {
    Coordinates vertices(graph.num_vertices(), kMaxCoordinate);
    for (Vertex v = 0; v < graph.num_vertices(); ++v) vertices.set(v, drawing.vertex(v));
    auto bends = std::make_shared<StoredBends>();
    for (EdgeId e = 0; e < graph.num_edges(); ++e) {
      drawing.polyline(e, points);
      if (e == moved) points[1] = points[1] + Vector{1, 0, 0};
      bends->add_edge({points[1], points[2]});
    }
    const Drawing broken("two-bend-109", kAxisLattice, std::move(vertices), graph.shared_edges(),
                         std::move(bends));
    const Certificate certificate = certify(graph, broken, row().guarantee);
    EXPECT_TRUE(certificate.violated());
    EXPECT_EQ(certificate.violations[0].kind, ViolationKind::vertex_angle);
  }
}

}  // namespace
}  // namespace ar3d::two_bend_109
