// The public function: corner cases, refusals, nested triangles, families.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/two_bend_120_support.h"
#include "ar3d/base/random.h"
#include "ar3d/generators/catalog.h"
#include "support/problem.h"

namespace ar3d::testing {
namespace {

std::string refusal_120(const Graph& graph) {
  return problem([&] { two_bend_120::draw(graph); }, "drawn");
}

TEST(TwoBend120, DrawsUnionsOfSmallGraphs) {
  EXPECT_EQ(two_bend_120_fault(Graph()), "");
  const Graph prism = generate(find_family("prism"), 6, 1);
  const Graph all = disjoint_union({complete(4), petersen(), prism, complete(4)});
  EXPECT_EQ(two_bend_120_fault(all), "");
  EXPECT_EQ(two_bend_120_fault(disjoint_union(std::vector<Graph>(40, complete(4)))), "");
  const auto counters = two_bend_120::draw(all).counters;
  const std::vector<Counter> expected = {{"components", 4}, {"core", 22}, {"small_cores", 4}};
  EXPECT_EQ(counters, expected) << "the prism becomes K4";
}

TEST(TwoBend120, RefusesWhatIsNot3ConnectedAndNamesTheCut) {
  const std::string begin = "two-bend-120 draws graphs whose components are cubic and 3-connected";
  const std::string end = " (vertices count from 0)";
  EXPECT_EQ(refusal_120(disjoint_union({complete(4), path(3)})),
            begin + ", but vertex 4 has degree 1" + end);
  // Two copies of K4 without an edge, joined by two edges; of K4 with a subdivided edge, by one.
  EXPECT_EQ(refusal_120(Graph(8, {{0, 1},
                                  {0, 2},
                                  {1, 2},
                                  {1, 3},
                                  {2, 3},
                                  {4, 5},
                                  {4, 6},
                                  {5, 6},
                                  {5, 7},
                                  {6, 7},
                                  {0, 4},
                                  {3, 7}})),
            begin + ", but edges 0 - 4 and 3 - 7 together cut one" + end);
  EXPECT_EQ(refusal_120(Graph(10, {{0, 1},
                                   {0, 2},
                                   {0, 3},
                                   {1, 2},
                                   {1, 3},
                                   {2, 4},
                                   {3, 4},
                                   {5, 6},
                                   {5, 7},
                                   {5, 8},
                                   {6, 7},
                                   {6, 8},
                                   {7, 9},
                                   {8, 9},
                                   {4, 9}})),
            begin + ", but edge 4 - 9 is a bridge" + end);
}

// Each level adds at most 1 to each reach in a chain, and triples the vertices in a tree.
TEST(TwoBend120, DrawsNestedTrianglesInAPolynomialBox) {
  for (const Graph& core :
       {complete(4), petersen(), generate(find_family("moebius-ladder"), 12, 1)}) {
    Graph chain = core, tree = core;
    RandomStream random(7);
    for (int i = 0; i < 200; ++i) {
      const Vertex last = chain.num_vertices() - 1;
      chain = with_triangle(chain, random.below(2) == 0 ? 0 : last);
      tree = with_triangle(tree, random.below(tree.num_vertices()));
    }
    EXPECT_EQ(two_bend_120_fault(chain), "");
    EXPECT_EQ(two_bend_120_fault(tree), "");
    Graph full = core;
    for (int level = 0; level < 4; ++level) {
      for (Vertex v = full.num_vertices(); v-- > 0;) full = with_triangle(full, v);
    }
    EXPECT_EQ(two_bend_120_fault(shuffled(full, 1)), "");
  }
}

TEST(TwoBend120, DrawsEveryFamilyThatIs3ConnectedAndNoOther) {
  int drawn = 0;
  for (const Family& family : families()) {
    for (const std::uint64_t n : {10u, 24u, 44u}) {
      const Graph graph = shuffled(generate(family, n, 3), n);
      const Components components = connected_components_of(graph);
      if (components.count != 1) continue;
      const bool draws = is_cubic_and_3_connected(graph);
      EXPECT_EQ(two_bend_120_fault(graph).empty(), draws) << family.name << ' ' << n;
      drawn += draws ? 1 : 0;
    }
  }
  EXPECT_GE(drawn, 30);
}

// Recorded with g++ 12.2; the same with every compiler and on every machine.
TEST(TwoBend120, DrawsTheSameEverywhere) {
  const Graph graph = generate(find_family("random-cubic"), 1000, 3);
  EXPECT_EQ(drawing_hash(two_bend_120::draw(graph)), "682544c105a2cd67fec3334c9b502f3b");
}

}  // namespace
}  // namespace ar3d::testing
