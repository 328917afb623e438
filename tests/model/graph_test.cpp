#include "ar3d/model/graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ar3d/model/error.h"
#include "support/graphs.h"

namespace ar3d {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string refusal(std::uint64_t n, std::vector<Edge> edges) {
  try {
    Graph(n, std::move(edges));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Graph, RowsStandInInputOrder) {
  const Graph g(4, {{2, 1}, {0, 1}, {1, 3}});
  EXPECT_EQ(g.num_vertices(), 4u);
  EXPECT_EQ(g.num_edges(), 3u);
  EXPECT_EQ(g.max_degree(), 3u);
  EXPECT_THAT(std::vector<HalfEdge>(g.incident(1).begin(), g.incident(1).end()),
              ElementsAre(HalfEdge{2, 0}, HalfEdge{0, 1}, HalfEdge{3, 2}));
  EXPECT_EQ(g.degree(3), 1u);
  EXPECT_EQ(g.other_end(0, 1), 2u);
}

TEST(Graph, EmptyAndEdgeless) {
  EXPECT_EQ(Graph().num_vertices(), 0u);
  EXPECT_EQ(Graph(5, {}).max_degree(), 0u);
  EXPECT_TRUE(Graph(5, {}).incident(4).empty());
}

TEST(Graph, RefusesWhatIsNotSimple) {
  EXPECT_THAT(refusal(3, {{0, 1}, {1, 1}}), HasSubstr("edge 1 (1, 1) is a loop"));
  EXPECT_THAT(refusal(3, {{0, 3}}), HasSubstr("vertex 3 is out of range"));
  EXPECT_THAT(refusal(3, {{0, 1}, {1, 0}}), HasSubstr("edge 1 (1, 0) is parallel"));
  std::vector<Edge> star;
  for (Vertex v = 1; v < 20; ++v) star.push_back({0, v});
  star.push_back({7, 0});
  EXPECT_THAT(refusal(20, star), HasSubstr("edge 19 (7, 0) is parallel"));
  EXPECT_THAT(refusal(std::uint64_t{1} << 33, {}), HasSubstr("too many"));
}

TEST(Graph, HashSeesOrderAndSize) {
  const std::string hash = graph_hash(Graph(3, {{0, 1}}));
  EXPECT_EQ(hash.size(), 32u);
  EXPECT_EQ(hash, graph_hash(Graph(3, {{0, 1}})));
  EXPECT_NE(hash, graph_hash(Graph(4, {{0, 1}})));
  EXPECT_NE(hash, graph_hash(Graph(3, {{1, 0}})));
}

TEST(Graph, RelabelsAndFindsComponents) {
  const Graph g = testing::disjoint_union({testing::cycle(3), testing::path(2), Graph(1, {})});
  const Components parts = connected_components_of(g);
  EXPECT_EQ(parts.count, 3u);
  EXPECT_THAT(parts.of, ElementsAre(0u, 0u, 0u, 1u, 1u, 2u));
  const std::vector<Vertex> reverse = {5, 4, 3, 2, 1, 0};
  EXPECT_EQ(relabelled(g, reverse).edge(0), (Edge{5, 4}));
  const std::vector<Vertex> twice = {0, 0, 1, 2, 3, 4};
  EXPECT_THROW(relabelled(g, twice), InputError);
}

TEST(Graph, GengDecodes) {
  EXPECT_EQ(testing::geng("-c -d3 -D3 6").size(), 2u);  // K3,3 and the prism
}

}  // namespace
}  // namespace ar3d
