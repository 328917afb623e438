// The stages of Theorem 1 against their invariants.
#include <set>

#include "algorithms/diamond_support.h"
#include "ar3d/algorithms/diamond/guaranteed.h"
#include "ar3d/algorithms/diamond/parity.h"
#include "ar3d/algorithms/diamond/placement.h"
#include "ar3d/algorithms/diamond/routes.h"
#include "ar3d/base/random.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

using namespace diamond;

/// Random graph of maximum degree 4: random pairs are joined where both ends have room.
Graph random_graph(Vertex n, unsigned tries, std::uint64_t seed) {
  RandomStream random(seed, 2);
  std::vector<unsigned> degree(n, 0);
  std::set<std::pair<Vertex, Vertex>> taken;
  std::vector<Edge> edges;
  for (unsigned i = 0; i < tries; ++i) {
    const Vertex u = random.below(n);
    const Vertex v = random.below(n);
    if (u == v || degree[u] == 4 || degree[v] == 4 || !taken.insert(std::minmax(u, v)).second)
      continue;
    edges.push_back({u, v});
    ++degree[u];
    ++degree[v];
  }
  return Graph(n, std::move(edges));
}

std::pair<Items, Items> items_of(const Graph& graph) {
  const PaddedNeighbours neighbours = padded_neighbours(graph);
  const TwoColouring colours = two_colouring(graph, neighbours, balanced_orientation(neighbours));
  return {extract_items(colours[kGreen]), extract_items(colours[kRed])};
}

std::vector<Graph> sample() {
  std::vector<Graph> graphs;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto n = static_cast<Vertex>(2 + seed * 3 / 2);
    graphs.push_back(random_graph(n, static_cast<unsigned>(n * (1 + seed % 6)), seed));
  }
  return graphs;
}

TEST(Colouring, OrientationIsBalanced) {
  for (const Graph& graph : sample()) {
    const PaddedNeighbours neighbours = padded_neighbours(graph);
    const auto [outs, ins] = balanced_orientation(neighbours);
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      const unsigned out = outs[v];
      const unsigned in = ins[v];
      EXPECT_EQ(out & in, 0u);
      EXPECT_EQ(out | in, (1u << graph.degree(v)) - 1);
      EXPECT_LE(__builtin_popcount(out), 2);
      EXPECT_LE(__builtin_popcount(in), 2);
    }
  }
}

/// Every vertex once, edges join consecutive vertices; counts the edges.
std::size_t check_items(const Graph& graph, const Items& items, std::vector<unsigned>& seen) {
  std::vector<Vertex> vertices = items.vertex;
  std::sort(vertices.begin(), vertices.end());
  for (Vertex v = 0; v < vertices.size(); ++v) EXPECT_EQ(vertices[v], v);
  std::size_t count = 0;
  for (std::uint32_t item = 0; item < items.count(); ++item) {
    for (std::uint32_t p = items.begin[item]; p < items.begin[item + 1]; ++p) {
      const bool last = p + 1 == items.begin[item + 1];
      const EdgeId e = items.edge[p];
      if (e == kNone) {
        EXPECT_TRUE(last);
        continue;
      }
      EXPECT_EQ(graph.other_end(e, items.vertex[p]),
                last ? items.first(item) : items.vertex[p + 1]);
      ++seen[e];
      ++count;
    }
  }
  return count;
}

TEST(Items, HoldEveryVertexInEachColourAndEveryEdgeOnce) {
  for (const Graph& graph : sample()) {
    const auto [green, red] = items_of(graph);
    std::vector<unsigned> seen(graph.num_edges(), 0);
    EXPECT_EQ(check_items(graph, green, seen) + check_items(graph, red, seen), graph.num_edges());
    EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](unsigned s) { return s == 1; }));
  }
}

TEST(Items, RotationAndArrangementKeepThem) {
  for (const Graph& graph : sample()) {
    auto [green, red] = items_of(graph);
    Arrangement backwards;
    for (std::uint32_t item = green.count(); item-- > 0;) {
      if (green.is_cycle(item)) {
        const EdgeId wanted = green.edge[green.begin[item] + 1];
        green.close_at(item, 1);
        EXPECT_EQ(green.edge[green.begin[item + 1] - 1], wanted);
      }
      backwards.push_back({item, item % 2 == 0});
    }
    std::vector<unsigned> seen(graph.num_edges(), 0);
    check_items(graph, arranged(green, backwards), seen);
    EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](unsigned s) { return s <= 1; }));
  }
}

TEST(Ordering, HasAtMostOneBadBoundary) {
  for (const Graph& graph : sample()) {
    for (const Items& items : {items_of(graph).first, items_of(graph).second}) {
      const Items ordered = arranged(items, order_items(graph, items));
      const std::vector<bool> bad = bad_boundaries(graph, ordered);
      const auto count = std::count(bad.begin(), bad.end(), true);
      EXPECT_LE(count, items.count() >= 6 ? 0 : graph.num_vertices() >= 4 ? 1 : 2);
    }
  }
}

/// Is the apex of a Z with the track at distance a from the first end on a turn? By walking the
/// plane path.
bool apex_on_turn(std::int32_t along, std::int32_t across, std::int32_t a) {
  const std::int32_t half = (along + across) / 2;
  return half == a || half == a + along;
}

TEST(ZDistance, WorksWheneverSomeTrackWorks) {
  for (std::int32_t along = 1; along < 40; ++along) {
    for (std::int32_t across = 1; across < 40; ++across) {
      if ((along + across) % 2 != 0) continue;
      bool some = false;
      for (std::int32_t a = 1; a < across; ++a) some = some || !apex_on_turn(along, across, a);
      const std::int32_t a = z_distance(along, -across);
      EXPECT_EQ(a > 0, some) << along << " " << across;
      if (a == 0) continue;
      EXPECT_LT(a, across);
      EXPECT_FALSE(apex_on_turn(along, across, a)) << along << " " << across;
    }
  }
  EXPECT_EQ(z_distance(2, 4), 2);  // the case that the paper's rule "distance 1" misses
}

TEST(Placements, KeepTheirInvariantsInEveryMode) {
  for (const Graph& graph : sample()) {
    const auto [green, red] = items_of(graph);
    const auto [guaranteed, gaps] = place_guaranteed(graph, green, red);
    EXPECT_TRUE(keeps_invariants(graph, guaranteed));
    for (const PlanePoint p : guaranteed.at) EXPECT_EQ((p.X | p.Y) & 1, 0);
    for (const auto& compact :
         {place_alternating(graph, green, red), place_in_pairs(graph, green, red)}) {
      EXPECT_TRUE(!compact || keeps_invariants(graph, compact->first));
    }
    RandomStream random(graph.num_edges(), 3);
    std::vector<std::uint8_t> parity(graph.num_vertices());
    for (auto& p : parity) p = random.chance(1, 2);
    const auto compact = place_by_parity(graph, green, red, parity);
    EXPECT_TRUE(!compact || keeps_invariants(graph, compact->first));
  }
}

TEST(Tracks, TellTheExtentsOfTheDrawing) {
  for (const Graph& graph : sample()) {
    auto [green, red] = items_of(graph);
    const Placement placement = place_guaranteed(graph, green, red).first;
    const Tracks tracks = choose_tracks(graph, placement);
    EXPECT_EQ(bounding_box(lift(graph, placement, tracks)).extents(), tracks.extents);
  }
}

TEST(Candidates, TheBoxIsDecidedExactly) {
  EXPECT_TRUE(fits_theorem_box({16, 16, 24}, 3));
  EXPECT_FALSE(fits_theorem_box({17, 16, 24}, 3));
  EXPECT_FALSE(fits_theorem_box({16, 17, 24}, 3));
  EXPECT_FALSE(fits_theorem_box({16, 16, 25}, 3));
  EXPECT_TRUE(fits_theorem_box({26, 26, 40}, 5));  // 80/3 = 26.67
  EXPECT_FALSE(fits_theorem_box({27, 26, 40}, 5));
}

TEST(Annealing, NeverCutsLessThanAlternatingAndOftenMore) {
  std::size_t better = 0;
  for (const Graph& graph : sample()) {
    const auto [green, red] = items_of(graph);
    std::vector<std::uint8_t> alternating(graph.num_vertices());
    for (std::size_t i = 0; i < alternating.size(); ++i) alternating[green.vertex[i]] = i % 2;
    const auto before = equal_neighbours(green, red, alternating);
    const auto after = equal_neighbours(green, red, annealed_parity(green, red));
    EXPECT_LE(after, before);
    better += after < before;
  }
  EXPECT_GT(better, 30u);
}

TEST(JointRotation, OnlyRotates) {
  std::size_t rotated = 0;
  for (const Graph& graph : sample()) {
    auto [green, red] = items_of(graph);
    const Items before = green;
    rotated += rotate_jointly(green, red);
    EXPECT_EQ(green.begin, before.begin);
    std::vector<unsigned> seen(graph.num_edges(), 0);
    EXPECT_EQ(check_items(graph, green, seen) + check_items(graph, red, seen), graph.num_edges());
  }
  EXPECT_GT(rotated, 10u);
}

}  // namespace
}  // namespace ar3d::testing
