#include "ar3d/model/graph.h"

#include <set>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/random.h"
#include "ar3d/model/isomorphism.h"
#include "support/graphs.h"
#include "support/problem.h"

namespace ar3d::testing {
namespace {

std::string refusal(std::uint64_t n, std::vector<Edge> edges) {
  return problem([&] { Graph(n, std::move(edges)); }, "accepted");
}

TEST(Graph, EdgesStandInCanonicalOrder) {
  const Graph g(4, {{2, 1}, {1, 0}, {3, 1}});
  EXPECT_EQ(g.num_vertices(), 4u);
  EXPECT_EQ(g.num_edges(), 3u);
  EXPECT_EQ(g.max_degree(), 3u);
  EXPECT_THAT(std::vector<Edge>(g.edges().begin(), g.edges().end()),
              ElementsAre(Edge{0, 1}, Edge{1, 2}, Edge{1, 3}));
  EXPECT_THAT(std::vector<HalfEdge>(g.incident(1).begin(), g.incident(1).end()),
              ElementsAre(HalfEdge{0, 0}, HalfEdge{2, 1}, HalfEdge{3, 2}));
  EXPECT_EQ(g.degree(3), 1u);
  EXPECT_EQ(g.other_end(0, 1), 0u);
}

bool before(Edge a, Edge b) { return std::pair(a.u, a.v) < std::pair(b.u, b.v); }

/// The plain version: std::sort, and rows filled in order of the edges.
std::vector<Edge> plain_canonical(std::vector<Edge> edges) {
  for (Edge& e : edges) e = {std::min(e.u, e.v), std::max(e.u, e.v)};
  std::sort(edges.begin(), edges.end(), before);
  return edges;
}

std::vector<std::vector<HalfEdge>> plain_rows(Vertex n, const std::vector<Edge>& edges) {
  std::vector<std::vector<HalfEdge>> rows(n);
  for (EdgeId e = 0; e < edges.size(); ++e) {
    rows[edges[e].u].push_back({edges[e].v, e});
    rows[edges[e].v].push_back({edges[e].u, e});
  }
  return rows;
}

void expect_plain(const Graph& g, const std::vector<Edge>& given) {
  const std::vector<Edge> edges = plain_canonical(given);
  ASSERT_TRUE(std::ranges::equal(g.edges(), edges));
  const auto rows = plain_rows(g.num_vertices(), edges);
  std::size_t longest = 0;
  for (Vertex v = 0; v < g.num_vertices(); ++v) {
    ASSERT_TRUE(std::ranges::equal(g.incident(v), rows[v])) << "vertex " << v;
    longest = std::max(longest, rows[v].size());
  }
  EXPECT_EQ(g.max_degree(), longest);
}

/// Every vertex joined to random later ones, and the first to every hundredth; m = 3n or so.
std::vector<Edge> many_edges(Vertex n) {
  RandomStream random(7);
  std::set<std::pair<Vertex, Vertex>> pairs;
  for (Vertex v = 1; v < n; ++v) {
    if (v % 100 == 0) pairs.emplace(0, v);
    for (int i = 0; i < 3; ++i) pairs.emplace(random.below(v), v);
  }
  std::vector<Edge> edges;
  for (const auto& [u, v] : pairs) edges.push_back({v, u});
  for (std::uint32_t e = 1; e < edges.size(); ++e) std::swap(edges[e], edges[random.below(e + 1)]);
  return edges;
}

TEST(Graph, ManyEdgesAreThoseOfThePlainVersion) {  // bins, chunks of 2^19 edges, long rows
  constexpr Vertex kVertices = 200000;
  std::vector<Edge> edges = many_edges(kVertices);
  ASSERT_GT(edges.size(), std::size_t{1} << 19);
  expect_plain(Graph(kVertices + 9, edges), edges);
  edges = plain_canonical(edges);
  expect_plain(Graph(kVertices, edges), edges);  // in order already
  std::swap(edges[0], edges[1]);
  expect_plain(Graph(kVertices, edges), edges);
}

TEST(Graph, FewEdgesAreThoseOfThePlainVersion) {
  RandomStream random(3);
  for (Vertex n = 2; n < 60; ++n) {
    std::vector<Edge> edges = many_edges(n);
    for (Edge& e : edges) {
      if (random.below(2) == 0) e = {e.v, e.u};
    }
    expect_plain(Graph(n, edges), edges);
  }
}

TEST(Graph, FindsAParallelEdgeAmongMany) {
  const std::vector<Edge> edges = many_edges(200000);
  for (const std::size_t place : {std::size_t{3}, edges.size() / 2, edges.size() - 1}) {
    std::vector<Edge> more = edges;
    more.push_back({edges[place].v, edges[place].u});
    try {
      const Graph accepted(200000, std::move(more));
      ADD_FAILURE() << "accepted";
    } catch (const EdgeError& error) {
      EXPECT_EQ(error.edge(), edges.size());
    }
  }
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

TEST(Graph, HashSeesVerticesAndEdgesAlone) {
  const std::string hash = graph_hash(Graph(3, {{0, 1}}));
  EXPECT_EQ(hash.size(), 32u);
  EXPECT_EQ(hash, graph_hash(Graph(3, {{0, 1}})));
  EXPECT_NE(hash, graph_hash(Graph(4, {{0, 1}})));
  EXPECT_NE(hash, graph_hash(Graph(3, {{0, 2}})));
  EXPECT_EQ(hash, graph_hash(Graph(3, {{1, 0}})));
  EXPECT_EQ(graph_hash(Graph(4, {{2, 3}, {1, 0}})), graph_hash(Graph(4, {{0, 1}, {3, 2}})));
}

TEST(Graph, RelabelsAndFindsComponents) {
  const Graph g = disjoint_union({cycle(3), path(2), Graph(1, {})});
  const Components parts = connected_components_of(g);
  EXPECT_EQ(parts.count, 3u);
  EXPECT_THAT(parts.of, ElementsAre(0u, 0u, 0u, 1u, 1u, 2u));
  const std::vector<Vertex> reverse = {5, 4, 3, 2, 1, 0};
  EXPECT_EQ(relabelled(g, reverse).edge(0), (Edge{1, 2}));
  const std::vector<Vertex> twice = {0, 0, 1, 2, 3, 4};
  EXPECT_THROW(relabelled(g, twice), InputError);
}

TEST(Graph, GengDecodes) {
  EXPECT_EQ(geng("-c -d3 -D3 6").size(), 2u);  // K3,3 and the prism
}

TEST(Isomorphism, IsTheFirstMapThatKeepsEdges) {
  const Graph path(3, {{0, 1}, {1, 2}}), other(3, {{0, 2}, {1, 2}}),
      triangle(3, {{0, 1}, {0, 2}, {1, 2}});
  const std::vector<Vertex> order = {1, 0, 2};
  EXPECT_THAT(find_isomorphism(path, other, order), ::testing::Optional(ElementsAre(0, 2, 1)));
  EXPECT_THAT(
      find_isomorphism(path, other, order, [](Vertex v, Vertex w) { return v != 0 || w == 1; }),
      ::testing::Optional(ElementsAre(1, 2, 0)));
  EXPECT_EQ(find_isomorphism(path, triangle, order), std::nullopt);
}

}  // namespace
}  // namespace ar3d::testing
