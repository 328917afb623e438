// Large graphs, and every graph of some sizes: certified.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "algorithms/two_bend_109_support.h"
#include "algorithms/two_bend_graphs.h"
#include "algorithms/two_bend_support.h"
#include "ar3d/generators/families.h"

namespace ar3d::testing {
namespace {

TEST(TwoBendLong, EveryGraphOfMaximumDegree3With12And13Vertices) {
  std::uint64_t seed = 0;
  for (const char* arguments : {"-D3 12", "-D3 13"}) {
    for (const Graph& graph : geng(arguments)) {
      expect_certified(graph);
      expect_certified(shuffled(graph, ++seed));
      if (HasFailure()) return;
    }
  }
}

/// Bridgeless ones have a SOURCE and a SINK in one block, the hardest case of the construction.
TEST(TwoBendLong, EveryConnectedCubicGraphUpTo18Vertices) {
  std::uint64_t seed = 0;
  for (int n = 4; n <= 18; n += 2) {
    for (const Graph& graph : geng(fmt::format("-c -d3 -D3 {}", n))) {
      const int relabellings = n <= 14 ? 40 : n == 16 ? 10 : 2;
      for (int i = 0; i < relabellings; ++i) {
        const Graph other = shuffled(graph, ++seed);
        expect_certified(other);
        if (n <= 16) expect_certified(other, {.force_safe_layout = true});
      }
      if (HasFailure()) return;
    }
  }
}

TEST(TwoBendLong, RandomGraphsOfAllKinds) {
  for (std::uint64_t seed = 1; seed <= 60000; ++seed) {
    const Vertex n = seed % 100 == 0 ? 200 : seed % 10 == 0 ? 60 : 20;
    const Graph graph = shuffled(random_graph_of_any_kind(n, seed), seed);
    expect_certified(graph);
    if (seed % 4 == 0) expect_certified(graph, {.force_safe_layout = true});
    if (HasFailure()) return;
  }
}

/// Two threads take the families in turn.
TEST(TwoBendLong, EveryFamilyWith10000VerticesAgreesWithTheOracle) {
  std::vector<std::pair<std::string, Graph>> inputs;
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    inputs.emplace_back(family.name, shuffled(generate(family, 10000, 3), 4));
  }
  const auto check = [&](std::size_t begin) {
    for (std::size_t i = begin; i < inputs.size(); i += 2) {
      const auto& [name, graph] = inputs[i];
      SCOPED_TRACE(name);
      const Drawing drawing = two_bend::draw(graph);
      for (const CrossingTest test : {CrossingTest::all_pairs, CrossingTest::halving}) {
        const Certificate certificate =
            certify(graph, drawing, find_algorithm("two-bend").guarantee, {.crossing_test = test});
        EXPECT_TRUE(certificate.valid() && certificate.complete)
            << certificate.violations.at(0).message;
      }
    }
  };
  std::thread other(check, 1);
  check(0);
  other.join();
}

/// No recursion, no quadratic step: every family with 10^5 vertices, some with 10^6, and triangles
/// nested 10^5 deep.
TEST(TwoBendLong, LargeGraphsAreCertifiedBySlabs) {
  for (const Family& family : families()) {
    if (family.max_degree > 3) continue;
    SCOPED_TRACE(family.name);
    const Graph graph = generate(family, 100000, 1);
    if (graph.num_vertices() > 110000) continue;
    expect_certified(shuffled(graph, 2));
  }
  expect_certified(nested_truncation(100000));
  for (const char* name : {"random-cubic", "random-cubic-tree", "random-tree", "prism", "path",
                           "flower-snark", "true-sinks"}) {
    SCOPED_TRACE(name);
    expect_certified(shuffled(generate(find_family(name), 1000000, 1), 2));
  }
}

TEST(TwoBendLong, EveryFamilyWithShuffledLabels) { expect_families_certified({500, 2000}); }

TEST(TwoBend109Long, RandomRegularGraphsOfAHundredThousandVertices) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Graph graph = generate(find_family("random-4-regular"), 100000, seed);
    for (const int effort : {0, 1}) {
      EXPECT_EQ(two_bend_109_fault(graph, {.effort = effort}), "") << "effort " << effort;
    }
  }
}

TEST(TwoBend109Long, EveryFamilyWithTenThousandVertices) {
  for (const Family& family : families()) {
    for (const int effort : {0, 1}) {
      const Graph graph = generate(family, 10000, 3, {{"shuffle", effort}});
      EXPECT_EQ(two_bend_109_fault(graph, {.effort = effort}), "") << family.name;
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
