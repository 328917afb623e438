#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/two_bend_graphs.h"
#include "algorithms/two_bend_support.h"
#include "ar3d/generators/catalog.h"

namespace ar3d {
namespace {

using testing::expect_certified;

TEST(TwoBendLong, EveryGraphOfMaximumDegree3With12And13Vertices) {
  std::uint64_t seed = 0;
  for (const char* arguments : {"-D3 12", "-D3 13"}) {
    for (const Graph& graph : testing::geng(arguments)) {
      expect_certified(graph);
      expect_certified(testing::shuffled(graph, ++seed));
      if (HasFailure()) return;
    }
  }
}

/// Bridgeless ones have a SOURCE and a SINK in one block, the hardest case of the construction.
TEST(TwoBendLong, EveryConnectedCubicGraphUpTo18Vertices) {
  std::uint64_t seed = 0;
  for (int n = 4; n <= 18; n += 2) {
    for (const Graph& graph : testing::geng(fmt::format("-c -d3 -D3 {}", n))) {
      const int relabellings = n <= 14 ? 40 : n == 16 ? 10 : 2;
      for (int i = 0; i < relabellings; ++i) {
        const Graph other = testing::shuffled(graph, ++seed);
        expect_certified(other);
        if (n <= 16) expect_certified(other, {.force_safe_round = true});
      }
      if (HasFailure()) return;
    }
  }
}

TEST(TwoBendLong, RandomGraphsOfAllKinds) {
  for (std::uint64_t seed = 1; seed <= 60000; ++seed) {
    const Vertex n = seed % 100 == 0 ? 200 : seed % 10 == 0 ? 60 : 20;
    const Graph graph = testing::shuffled(testing::random_graph_of_any_kind(n, seed), seed);
    expect_certified(graph);
    if (seed % 4 == 0) expect_certified(graph, {.force_safe_round = true});
    if (HasFailure()) return;
  }
}

TEST(TwoBendLong, EveryFamilyWithShuffledLabels) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    for (const std::uint64_t n : {500u, 2000u}) {
      SCOPED_TRACE(family.name);
      const Graph graph = generate(family, n, n);
      expect_certified(graph);
      expect_certified(testing::shuffled(graph, n));
    }
  }
}

}  // namespace
}  // namespace ar3d
