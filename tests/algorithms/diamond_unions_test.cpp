// Random disjoint unions of graphs that force contained cycles, bumps and offsets, under random
// names.
#include "algorithms/diamond_support.h"
#include "ar3d/base/random.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

/// Triangles (3i, 3i+1, 3i+2), k of them, with a cycle through all 3k vertices that runs along no
/// triangle edge.
Graph cycle_through_triangles(Vertex k) {
  std::vector<Edge> edges;
  for (Vertex i = 0; i < k; ++i) {
    edges.push_back({3 * i, 3 * i + 1});
    edges.push_back({3 * i + 1, 3 * i + 2});
    edges.push_back({3 * i + 2, 3 * i});
  }
  for (Vertex j = 0; j < 3; ++j) {
    for (Vertex i = 0; i < k; ++i) {
      const Vertex next = i + 1 < k ? 3 * (i + 1) + j : (j + 1) % 3;
      edges.push_back({3 * i + j, next});
    }
  }
  return Graph(3 * k, std::move(edges));
}

Graph random_union(std::uint64_t seed) {
  RandomStream random(seed, 4);
  std::vector<Graph> parts;
  for (std::uint32_t i = 1 + random.below(6); i > 0; --i) {
    const Graph kinds[] = {complete(5),
                           octahedron(),
                           complete(1 + random.below(4)),
                           cycle(3 + random.below(6)),
                           path(1 + random.below(6)),
                           petersen(),
                           squared_cycle(5 + random.below(8)),
                           cycle_through_triangles(2 + random.below(4))};
    parts.push_back(kinds[random.below(8)]);
  }
  return shuffled(disjoint_union(parts), seed);
}

TEST(DiamondUnions, AreCertifiedAndReachTheRareCases) {
  CounterSums total;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const Graph graph = random_union(seed);
    for (const diamond::Options& options : diamond_modes()) {
      const Drawing drawing = diamond::draw(graph, options);
      ASSERT_EQ(diamond_fault(graph, drawing), "") << "seed " << seed;
      if (options.effort == 0) add_counters(drawing, total);
    }
  }
  for (const char* rare : {"contained", "rho", "bumps", "offsets"})
    EXPECT_GT(total[rare], 0) << rare;
}

}  // namespace
}  // namespace ar3d::testing
