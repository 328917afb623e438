// Random disjoint unions of graphs that force contained cycles, bumps and offsets, under random
// names.
#include <map>

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
    switch (random.below(8)) {
      case 0:
        parts.push_back(complete(5));
        break;
      case 1:
        parts.push_back(octahedron());
        break;
      case 2:
        parts.push_back(complete(1 + random.below(4)));
        break;
      case 3:
        parts.push_back(cycle(3 + random.below(6)));
        break;
      case 4:
        parts.push_back(path(1 + random.below(6)));
        break;
      case 5:
        parts.push_back(petersen());
        break;
      case 6:
        parts.push_back(squared_cycle(5 + random.below(8)));
        break;
      default:
        parts.push_back(cycle_through_triangles(2 + random.below(4)));
        break;
    }
  }
  return shuffled(disjoint_union(parts), seed);
}

TEST(DiamondUnions, AreCertifiedAndReachTheRareCases) {
  std::map<std::string, std::int64_t> total;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const Graph graph = random_union(seed);
    for (const diamond::Options& options : diamond_modes()) {
      const Drawing drawing = diamond::draw(graph, options);
      ASSERT_EQ(diamond_fault(graph, drawing), "") << "seed " << seed;
      if (options.effort == 0) {
        for (const Counter& c : drawing.counters) total[c.name] += c.value;
      }
    }
  }
  for (const char* rare : {"contained", "rho", "bumps", "offsets"})
    EXPECT_GT(total[rare], 0) << rare;
}

}  // namespace
}  // namespace ar3d::testing
