// Pieces of the two space-fillers: found again from the bare graph, certified, and refused in words
// that say what is known.
#include "ar3d/algorithms/lattice/lattice.h"

#include <set>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/lattice/embedding.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "support/graphs.h"
#include "support/problem.h"

namespace ar3d::testing {
namespace {

using lattice::Embedding;
using lattice::SpaceNet;

bool is_drawn_right(const char* algorithm, const Graph& graph) {
  const Algorithm& row = find_algorithm(algorithm);
  const Drawing drawing = draw(row, graph);
  return drawing.algorithm() == algorithm && certify(graph, drawing, row.guarantee).valid();
}

std::string refusal(const char* algorithm, const Graph& graph) {
  return problem([&] { draw(find_algorithm(algorithm), graph); }, "drawn");
}

Graph family(const char* name, std::uint64_t n, std::uint64_t seed) {
  return generate(find_family(name), n, seed, {{"shuffle", 1}});
}

TEST(Lattice, FindsShuffledPieces) {
  for (const std::uint64_t n : {1, 2, 5, 17, 60, 250, 2000}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      EXPECT_TRUE(is_drawn_right("lattice-109", family("diamond-lattice", n, seed))) << n;
      EXPECT_TRUE(is_drawn_right("lattice-120", family("laves-graph", n, seed))) << n;
      EXPECT_TRUE(is_drawn_right("lattice-109", family("honeycomb", n, seed))) << n;
    }
  }
}

TEST(Lattice, FindsPercolatedPiecesAndPacksTheirComponents) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Graph diamond = family("percolated-diamond-lattice", 600, seed);
    ASSERT_GT(connected_components_of(diamond).count, 5u);
    EXPECT_TRUE(is_drawn_right("lattice-109", diamond)) << seed;
    EXPECT_TRUE(is_drawn_right("lattice-120", family("percolated-laves-graph", 600, seed)));
    EXPECT_TRUE(is_drawn_right("lattice-109", family("percolated-honeycomb", 150, seed))) << seed;
  }
}

TEST(Lattice, PacksSmallComponentsIntoACube) {
  const Drawing drawing = draw(find_algorithm("lattice-109"), Graph(1000, {}));
  for (const std::int64_t extent : bounding_box(drawing).extents()) EXPECT_LE(extent, 40);
  EXPECT_TRUE(is_drawn_right("lattice-109", Graph(0, {})));
  EXPECT_TRUE(
      is_drawn_right("lattice-109", disjoint_union({cycle(6), path(9), cycle(6), path(2)})));
  EXPECT_TRUE(is_drawn_right("lattice-120", disjoint_union({cycle(10), path(9), cycle(10)})));
}

TEST(Lattice, SaysWhyAGraphIsNoPiece) {
  EXPECT_EQ(refusal("lattice-109", disjoint_union({cycle(6), cycle(7)})),
            "no piece of the diamond lattice: the component of vertex 6 (7 vertices) has an odd "
            "cycle");
  EXPECT_THAT(
      refusal("lattice-109", cycle(4)),
      MatchesRegex("no piece of the diamond lattice: the component of vertex 0 .4 vertices. "
                   "is no subgraph of it: all [0-9]+ tries failed"));
  EXPECT_THAT(refusal("lattice-120", cycle(6)), HasSubstr("is no subgraph of it"));
  EXPECT_THAT(refusal("lattice-120", cycle(8)), HasSubstr("is no subgraph of it"));
  EXPECT_THAT(refusal("lattice-120", complete(5)), HasSubstr("maximum degree 3"));
  const std::string open = refusal("lattice-109", family("binary-tree", 400, 1));
  EXPECT_THAT(open, HasSubstr("is not decided"));
  EXPECT_THAT(open, Not(HasSubstr("no piece")));
}

/// All subgraphs of the net on n vertices with the first at the origin, by plain backtracking: the
/// oracle.
bool embeds(const Graph& graph, const SpaceNet& net, std::vector<Point>& points) {
  const auto v = static_cast<Vertex>(points.size());
  if (v == graph.num_vertices()) return true;
  std::set<std::tuple<std::int64_t, std::int64_t, std::int64_t>> candidates;
  for (const HalfEdge& half : graph.incident(v)) {
    if (half.to >= v) continue;
    for (const Vector step : net.steps(points[half.to])) {
      const Point p = points[half.to] + step;
      candidates.emplace(p.x, p.y, p.z);
    }
  }
  for (const auto& [x, y, z] : candidates) {
    const Point point{x, y, z};
    if (std::find(points.begin(), points.end(), point) != points.end()) continue;
    const auto incident = graph.incident(v);
    if (!std::all_of(incident.begin(), incident.end(), [&](const HalfEdge& half) {
          return half.to >= v || net.are_adjacent(point, points[half.to]);
        })) {
      continue;
    }
    points.push_back(point);
    if (embeds(graph, net, points)) return true;
    points.pop_back();
  }
  return false;
}

/// With labels along a breadth-first search, so that every vertex but the first has an earlier one.
Graph in_search_order(const Graph& graph) {
  std::vector<Vertex> name(graph.num_vertices(), graph.num_vertices()), queue = {0};
  name[0] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const HalfEdge& half : graph.incident(queue[i])) {
      if (name[half.to] < graph.num_vertices()) continue;
      name[half.to] = static_cast<Vertex>(queue.size());
      queue.push_back(half.to);
    }
  }
  return relabelled(graph, name);
}

TEST(Lattice, DecidesSmallBipartiteGraphsAsPlainBacktrackingDoes) {
  std::size_t found = 0, none = 0;
  for (const char* arguments : {"-c -b -D4 7", "-c -b -D4 8", "-c -b -t -D3 11 10:13"}) {
    for (const Graph& graph : geng(arguments)) {
      for (const SpaceNet* net : {&SpaceNet::diamond(), &SpaceNet::laves()}) {
        if (graph.max_degree() > net->steps({}).size()) continue;
        const Embedding embedding = lattice::embed(graph, *net, 1000000);
        ASSERT_FALSE(embedding.is_given_up);
        std::vector<Point> points = {{}};
        const bool expected = embeds(in_search_order(graph), *net, points);
        EXPECT_EQ(!embedding.points.empty(), expected);
        (expected ? found : none) += 1;
      }
    }
  }
  EXPECT_GT(found, 50u);
  EXPECT_GT(none, 50u);
}

TEST(Lattice, EarsBeginBesideWhatIsPlacedAndEndThere) {
  for (const char* name : {"diamond-lattice", "caterpillar", "laves-graph"}) {
    const Graph graph = family(name, 300, 2);
    const auto steps = lattice::ear_order(graph);
    ASSERT_EQ(steps.size(), graph.num_vertices());
    std::set<Vertex> seen;
    for (std::uint32_t i = 0; i < steps.size(); ++i) {
      EXPECT_TRUE(seen.insert(steps[i].vertex).second);
      if (i == 0) continue;
      ASSERT_LT(steps[i].from, i);
      const auto incident = graph.incident(steps[i].vertex);
      EXPECT_TRUE(std::any_of(incident.begin(), incident.end(), [&](const HalfEdge& half) {
        return half.to == steps[steps[i].from].vertex;
      }));
      EXPECT_TRUE(steps[i].target == lattice::kNoStep || steps[i].target < i);
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
