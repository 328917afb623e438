// What is needed: each rule broken, and what then goes wrong.

#include <functional>
#include <vector>

#include "algorithms/two_bend_109_support.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::two_bend_109 {
namespace {

/// Places the graph after `change` has been applied to every vertex.
bool placed(const Graph& graph,
            const std::function<void(Vertex, SlotArrangement&, Layout&)>& change) {
  const OrderedGraph order = testing::ordered(graph);
  SlotArrangement arrangement = arrange(order);
  Layout layout = lay_out(order, order.parts, arrangement, {16});
  for (Vertex v = 0; v < graph.num_vertices(); ++v) change(v, arrangement, layout);
  Placement placement(graph.num_vertices());
  return place(order, order.parts, arrangement, layout, 1, placement);
}

bool is_three_down(const SlotArrangement& arrangement, Vertex v) {
  return (arrangement.stubs[v] | 2) == number_of_stubs(Stance::three_down, 3, true);
}

TEST(TwoBend109Mutation, TurnsTooMuchWhenARuleIsBroken) {
  const Graph random = generate(find_family("random-4-regular"), 60, 3);
  EXPECT_TRUE(placed(random, [](Vertex, SlotArrangement&, Layout&) {})) << "unbroken";
  EXPECT_THROW(placed(random, [](Vertex v, auto&, Layout& l) { l.position[v].z /= 8; }),
               InternalError)
      << "lower heights";
  EXPECT_THROW(placed(random, [](Vertex v, auto&, Layout& l) { l.position[v].x /= 40; }),
               InternalError)
      << "narrow slots";
  EXPECT_THROW(placed(random, [](Vertex v, auto&, Layout& l) { l.position[v].y = 0; }),
               InternalError)
      << "pairs without a gap";
  const auto stands_elsewhere = [](Vertex v, const SlotArrangement& a, Layout& layout) {
    if (is_three_down(a, v)) layout.position[v].x += 10'000'000;
  };
  EXPECT_THROW(placed(random, stands_elsewhere), InternalError)
      << "three down must stand between its neighbours";
  const auto is_mirrored = [](Vertex v, SlotArrangement& a, const Layout&) {
    if (is_three_down(a, v)) a.stubs[v] ^= 2;
  };
  EXPECT_THROW(placed(random, is_mirrored), InternalError)
      << "three down needs its lone stub on the side of one";
  const auto is_chain = [](Vertex v, SlotArrangement& a, const Layout&) {
    if (a.spot[v] == SlotSpot::lower) a.stubs[v] = number_of_stubs(Stance::chain, 0);
  };
  EXPECT_THROW(placed(testing::cycle(8), is_chain), InternalError)
      << "corners of a cycle need their own stance";
}

// The verifier sees what the construction must not do.
TEST(TwoBend109Mutation, AMovedBendIsFound) {
  const Graph graph = testing::octahedron();
  const Drawing drawing = draw(graph);
  std::vector<Point> at, points;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) at.push_back(drawing.vertex(v));
  std::vector<std::vector<Point>> bends;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    drawing.polyline(e, points);
    bends.push_back({points[1], points[2]});
  }
  for (auto& both : bends) {
    both[0] = both[0] + Vector{1, 0, 0};
    const Drawing broken = testing::two_bend_drawing(graph.edges(), at, bends);
    both[0] = both[0] + Vector{-1, 0, 0};
    const Certificate certificate = certify(graph, broken, row().guarantee);
    EXPECT_TRUE(certificate.violated());
    EXPECT_EQ(certificate.violations[0].kind, ViolationKind::vertex_angle);
  }
}

}  // namespace
}  // namespace ar3d::two_bend_109
