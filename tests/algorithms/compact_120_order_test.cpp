// Steps D.1 to D.6: colours, moves, owners, arms, levels.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "algorithms/strips_support.h"
#include "ar3d/algorithms/compact_120/order.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::compact_120 {
namespace {

/// Empty if the links keep docs/compact-120.md's rules for classes, owners and arms.
std::string fault_of_links(const Graph& graph, const Links& links) {
  std::vector<int> tails(graph.num_edges(), 0);
  std::vector<int> ends(graph.num_edges(), 0);
  std::vector<std::set<unsigned>> told(graph.num_edges());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    int degree = 0;
    int right = 0;
    for (const Arm arm : kArms) {
      const ArmLink& link = links.at[v][arm];
      if (!link.is_set()) continue;
      ++degree;
      ++ends[link.edge];
      tails[link.edge] += link.is_out != 0 ? 1 : 0;
      right += link.is_right != 0 ? 1 : 0;
      told[link.edge].insert(link.at);
      if (graph.other_end(link.edge, v) != link.to) return "another edge";
      if (link.is_out != 0 && arm != (link.is_right != 0 ? k01 : k20)) return "own arm";
      if (link.is_out == 0 && link.arrival() != arrival_on(arm, links.of[v])) return "arrival";
      const Arm side = (links.of[v] == Class::n) == (link.is_right != 0) ? k01 : k20;
      if (link.is_out == 0 && arm != k12 && arm != side) return "arm of the wrong side";
    }
    const bool full = graph.degree(v) == 3;
    const Class expected = full && right == 3 ? Class::s : full && right == 0 ? Class::t : Class::n;
    if (degree != static_cast<int>(graph.degree(v)) || links.of[v] != expected) return "class";
  }
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    if (ends[e] != 2 || tails[e] != 1 || told[e].size() != 1) return "ends of an edge";
  }
  return "";
}

std::string fault_of_order(const Graph& graph) {
  const Order order = moved_order(graph);
  for (const Edge& edge : graph.edges()) {
    if (order.rank[edge.u] == order.rank[edge.v]) return "equal ranks";
  }
  if (std::set<unsigned>(order.rank.begin(), order.rank.end()).size() > 76) return "ranks";
  const Order levels = in_levels(graph, order);
  for (const Edge& edge : graph.edges()) {
    if (order.is_right(edge.u, edge.v) != levels.is_right(edge.u, edge.v)) return "levels";
  }
  const Owners owners = choose_owners(graph, order);
  if (!owners.crowded.empty()) return "two cycles";
  return fault_of_links(graph, assign_arms(graph, order, owners));
}

TEST(Compact120Order, ColoursDifferUpToDistanceTwo) {
  const Graph graph = generate(find_family("random-cubic"), 400, 3);
  const std::vector<std::uint8_t> colours = distance_two_colours(graph);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    EXPECT_LT(colours[v], 10);
    std::set<int> around = {colours[v]};
    for (const HalfEdge& edge : graph.incident(v)) {
      EXPECT_TRUE(around.insert(colours[edge.to]).second);
    }
  }
}

TEST(Compact120Order, IsRightOnSmallGraphsUnderManyLabellingsAndOnFamilies) {
  std::uint64_t seed = 0;
  for (int n = 1; n <= 12; ++n) {
    const bool is_cubic = n > 8;  // all up to 8 vertices, the connected cubic ones up to 12
    if (is_cubic && n % 2 != 0) continue;
    for (const Graph& graph :
         testing::geng(fmt::format("{} -D3 {}", is_cubic ? "-c -d3" : "", n))) {
      for (int i = 0; i < (is_cubic || graph.num_edges() * 2 == 3u * n ? 20 : 5); ++i) {
        ASSERT_EQ(fault_of_order(testing::shuffled(graph, ++seed)), "") << "seed " << seed;
      }
    }
  }
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    for (const int shuffle : {0, 1}) {
      EXPECT_EQ(fault_of_order(generate(family, 1000, 3, {{"shuffle", shuffle}})), "")
          << family.name;
    }
  }
}

/// Steps D.2 and D.3 make both kinds of moves: without them some slot graphs have two cycles.
TEST(Compact120Mutation, TheMovesAreNeeded) {
  int crowded = 0;
  for (const Graph& graph : testing::geng("-c -d3 -D3 10")) {
    Order order;
    for (const std::uint8_t colour : distance_two_colours(graph)) order.rank.push_back(colour);
    crowded += choose_owners(graph, order).crowded.empty() ? 0 : 1;
  }
  EXPECT_GT(crowded, 0);
}

TEST(Compact120Levels, AreFewAndLeaveFewExtremeVertices) {
  const Graph graph = generate(find_family("random-cubic"), 10000, 3);
  const NarrowOrder order = narrow_order(graph, strips::NumbersAhead(1));
  EXPECT_EQ(order.moved_components, 0);
  EXPECT_EQ(fault_of_links(graph, order.links), "");
  EXPECT_EQ(std::set<int>(order.position.begin(), order.position.end()).size(), 4u);
}

TEST(Compact120Levels, AreRightOnSmallGraphsAndFamilies) {
  for (int n = 1; n <= 8; ++n) {
    for (const Graph& graph : testing::geng(fmt::format("-D3 {}", n))) {
      ASSERT_EQ(fault_of_links(graph, narrow_order(graph, strips::NumbersAhead(1)).links), "");
    }
  }
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    const Graph graph = generate(family, 1000, 3);
    EXPECT_EQ(fault_of_links(graph, narrow_order(graph, strips::NumbersAhead(1)).links), "")
        << family.name;
  }
}

void expect_positions_grow(const Graph& graph, const NarrowOrder& order) {
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const ArmLink& link : order.links.at[v]) {
      if (!link.is_set() || link.is_right == 0) continue;
      EXPECT_LE(order.position[v], order.position[link.to]);
    }
  }
}

TEST(Compact120Levels, PositionsGrowAlongEdges) {
  for (const char* name : {"random-cubic", "union-k4", "random-cubic-tree"}) {
    const Graph graph = generate(find_family(name), 200, 3);
    expect_positions_grow(graph, narrow_order(graph, strips::NumbersAhead(1)));
  }
}

TEST(Compact120Levels, GiveWayToTheMovedOrderWhereTheyFail) {
  const Graph graph = generate(find_family("union-k33"), 600, 3);
  const NarrowOrder order = narrow_order(graph, strips::NumbersAhead(1), 0);
  EXPECT_GT(order.moved_components, 0);
  EXPECT_LT(order.moved_components, 100);
  EXPECT_EQ(fault_of_links(graph, order.links), "");
  expect_positions_grow(graph, order);
  Census census;
  EXPECT_TRUE(fill_narrow_strip(order, graph.num_edges(), {}, strips::NumbersAhead(1), census));
}

}  // namespace
}  // namespace ar3d::compact_120
