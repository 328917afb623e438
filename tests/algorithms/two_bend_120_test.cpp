// The public function: corner cases, refusals, nested triangles, families.

#include <fmt/format.h>
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

TEST(TwoBend120, RefusesBridgesAndWhatHasNoEnds) {
  const std::string begin =
      "two-bend-120 draws graphs whose components are cubic and have no bridge";
  const std::string end = " (vertices count from 0)";
  EXPECT_EQ(refusal_120(disjoint_union({complete(4), path(3)})),
            begin + ", but vertex 4 has degree 1" + end);
  // Two copies of K4 without an edge, joined by two edges; of K4 with a subdivided edge, by one.
  EXPECT_EQ(
      refusal_120(Graph(8, {{0, 1},
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
      "two-bend-120 found no drawing of the component of vertex 0, which two edges cut" + end);
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

/// Cubic graphs without an edge each, in a ring: any two of its edges cut it.
Graph ring_of(const std::vector<Graph>& parts) {
  std::vector<Edge> edges, ends;
  Vertex n = 0;
  for (const Graph& part : parts) {
    ends.push_back({part.edge(0).u + n, part.edge(0).v + n});
    for (EdgeId e = 1; e < part.num_edges(); ++e) {
      edges.push_back({part.edge(e).u + n, part.edge(e).v + n});
    }
    n += part.num_vertices();
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    edges.push_back({ends[i].v, ends[(i + 1) % ends.size()].u});
  }
  return Graph(n, std::move(edges));
}

TEST(TwoBend120, DrawsRingsOf3ConnectedGraphs) {
  const Family& cubic = find_family("random-cubic");
  int drawn = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    std::vector<Graph> parts;
    RandomStream random(seed);
    while (parts.size() < 2 + seed % 4) {
      Graph part =
          shuffled(generate(cubic, 8 + 2 * random.below(12), seed + 100 * parts.size()), seed);
      if (is_cubic_and_3_connected(part)) parts.push_back(std::move(part));
      if (parts.empty()) parts.push_back(petersen());
    }
    const Graph ring = shuffled(ring_of(parts), seed);
    drawn += is_drawn_or_refused_120(ring, false) ? 1 : 0;
  }
  EXPECT_GE(drawn, 80);
}

TEST(TwoBend120, DrawsEveryNamedGraphThatIs3Connected) {
  int drawn = 0;
  for (int index = 0; index <= 50; ++index) {
    const Graph graph = generate(find_family("named"), 1, 1, {{"index", index}});
    if (connected_components_of(graph).count != 1) continue;
    const bool is_connected = graph.num_vertices() > 3 && is_cubic_and_3_connected(graph);
    drawn += is_drawn_or_refused_120(graph, is_connected) ? 1 : 0;
  }
  EXPECT_GE(drawn, 20);
}

TEST(TwoBend120, DrawsEveryFamilyThatIs3Connected) {
  int drawn = 0;
  for (const Family& family : families()) {
    for (const std::uint64_t n : {10u, 24u, 44u}) {
      const Graph graph = shuffled(generate(family, n, 3), n);
      const Components components = connected_components_of(graph);
      if (components.count != 1) continue;
      SCOPED_TRACE(fmt::format("{} {}", family.name, n));
      drawn += is_drawn_or_refused_120(graph, is_cubic_and_3_connected(graph)) ? 1 : 0;
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
