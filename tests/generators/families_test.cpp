#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "ar3d/generators/catalog.h"
#include "support/graph_facts.h"

namespace ar3d::testing {
namespace {

/// What is known of one graph of a family. -1: says nothing.
struct Expectation {
  std::string family;
  std::uint64_t requested_n;
  std::uint64_t n;
  std::int64_t m;
  std::int64_t bridges;
  std::int64_t components;
  std::int64_t connectivity;
  std::map<std::uint32_t, std::uint64_t> degrees;  // empty: says nothing
  Settings parameters = {};
};

constexpr std::int64_t kAny = -1;

// family, requested n, n, m, bridges, components, vertex connectivity (up to 4), degree ->
// vertices, parameters
// clang-format off
const std::vector<Expectation> kExpectations = {
    {"edgeless", 1, 1, 0, 0, 1, 0, {{0, 1}}},
    {"edgeless", 7, 7, 0, 0, 7, 0, {{0, 7}}},
    {"perfect-matching", 9, 8, 4, 4, 4, 0, {{1, 8}}},
    {"path", 0, 1, 0, 0, 1, 0, {{0, 1}}},
    {"path", 9, 9, 8, 8, 1, 1, {{1, 2}, {2, 7}}},
    {"cycle", 2, 3, 3, 0, 1, 2, {{2, 3}}},
    {"cycle", 10, 10, 10, 0, 1, 2, {{2, 10}}},
    {"stars", 14, 12, 9, 9, 3, 0, {{1, 9}, {3, 3}}},
    {"stars", 14, 10, 8, 8, 2, 0, {{1, 8}, {4, 2}}, {{"leaves", 4}}},
    {"caterpillar", 10, 10, 9, 9, 1, 1, {{1, 5}, {2, 2}, {3, 3}}},
    {"caterpillar", 14, 12, 11, 11, 1, 1, {{1, 8}, {3, 2}, {4, 2}}, {{"legs", 2}}},
    {"binary-tree", 10, 10, 9, 9, 1, 1, {{1, 5}, {2, 2}, {3, 3}}},
    {"spine-with-pendant-trees", 45, 40, 39, 39, 1, 1, {}},
    {"ladder", 11, 10, 13, 0, 1, 2, {{2, 4}, {3, 6}}},
    {"prism", 13, 12, 18, 0, 1, 3, {{3, 12}}},
    {"moebius-ladder", 4, 4, 6, 0, 1, 3, {{3, 4}}},
    {"moebius-ladder", 10, 10, 15, 0, 1, 3, {{3, 10}}},
    {"squared-cycle", 5, 5, 10, 0, 1, 4, {{4, 5}}},
    {"squared-cycle", 11, 11, 22, 0, 1, 4, {{4, 11}}},
    {"square-grid", 18, 16, 24, 0, 1, 2, {{2, 4}, {3, 8}, {4, 4}}},
    {"torus", 22, 20, 40, 0, 1, 4, {{4, 20}}},
    {"torus", 1, 9, 18, 0, 1, 4, {{4, 9}}, {{"rows", 3}}},
    {"generalised-petersen", 10, 10, 15, 0, 1, 3, {{3, 10}}},
    {"generalised-petersen", 10, 14, 21, 0, 1, 3, {{3, 14}}, {{"k", 3}}},
    {"flower-snark", 27, 20, 30, 0, 1, 3, {{3, 20}}},
    {"cubic-tree", 10, 10, 15, 1, 1, 1, {{3, 10}}},
    {"cubic-tree", 40, 40, 60, 11, 1, 1, {{3, 40}}},
    {"cubic-tree", 38, 38, 57, 7, 1, 1, {{3, 38}}, {{"leaf", 7}, {"shape", 1}}},
    {"random-cubic-tree", 12, 12, 18, 1, 1, 1, {{3, 12}}},
    {"random-cubic-tree", 47, 46, 69, kAny, 1, 1, {{3, 46}}},
    {"union-triangle", 11, 9, 9, 0, 3, 0, {{2, 9}}},
    {"union-k4", 11, 8, 12, 0, 2, 0, {{3, 8}}},
    {"union-k5", 11, 10, 20, 0, 2, 0, {{4, 10}}},
    {"union-k33", 12, 12, 18, 0, 2, 0, {{3, 12}}},
    {"union-octahedron", 12, 12, 24, 0, 2, 0, {{4, 12}}},
    {"union-petersen", 29, 20, 30, 0, 2, 0, {{3, 20}}},
    {"union-flower-snark", 40, 40, 60, 0, 2, 0, {{3, 40}}},
    {"random-regular", 21, 20, 30, kAny, kAny, kAny, {{3, 20}}},
    {"random-regular", 21, 21, 42, kAny, kAny, kAny, {{4, 21}}, {{"degree", 4}}},
    {"random-regular", 21, 21, 21, 0, kAny, kAny, {{2, 21}}, {{"degree", 2}}},
    {"random-regular", 21, 20, 10, 10, 10, 0, {{1, 20}}, {{"degree", 1}}},
    {"random-cubic", 1, 4, 6, 0, 1, 3, {{3, 4}}},
    {"random-cubic", 30, 30, 45, kAny, kAny, kAny, {{3, 30}}},
    {"random-4-regular", 5, 5, 10, 0, 1, 4, {{4, 5}}},
    {"random-4-regular", 31, 31, 62, kAny, kAny, kAny, {{4, 31}}},
    {"random-max-degree", 50, 50, 70, kAny, kAny, kAny, {}},
    {"random-max-degree", 4, 4, 5, kAny, kAny, kAny, {}},
    {"random-max-degree", 3, 3, 3, 0, 1, 2, {{2, 3}}, {{"edges-per-vertex", 2000000}}},
    {"random-max-degree", 20, 20, 30, kAny, kAny, kAny, {{3, 20}}, {{"degree", 3}, {"edges-per-vertex", 1500000}}},
    {"random-tree", 30, 30, 29, 29, 1, 1, {}},
    {"random-tree", 9, 9, 8, 8, 1, 1, {{1, 2}, {2, 7}}, {{"degree", 2}}},
    {"circulant", 13, 13, 26, 0, 1, 4, {{4, 13}}},
    {"circulant", 12, 12, 24, 0, 2, 0, {{4, 12}}, {{"a", 2}, {"b", 4}}},
    {"hypercube", 15, 8, 12, 0, 1, 3, {{3, 8}}},
    {"hypercube", 999, 16, 32, 0, 1, 4, {{4, 16}}},
    {"honeycomb", 6, 6, 6, 0, 1, 2, {{2, 6}}},
    {"honeycomb", 30, 24, 30, 0, 1, 2, {{2, 12}, {3, 12}}},
    {"honeycomb", 54, 54, 72, 0, 1, 2, {{2, 18}, {3, 36}}},
    {"diamond-lattice", 5, 5, 4, 4, 1, 1, {{1, 4}, {4, 1}}},
    {"diamond-lattice", 40, 40, kAny, kAny, 1, kAny, {}},
    {"laves-graph", 4, 4, 3, 3, 1, 1, {{1, 3}, {3, 1}}},
    {"laves-graph", 60, 60, kAny, kAny, 1, kAny, {}},
    {"percolated-square-grid", 16, 16, 24, 0, 1, 2, {}, {{"keep", 1000000}}},
    {"percolated-honeycomb", 24, 24, 0, 0, 24, 0, {}, {{"keep", 0}}},
    {"percolated-diamond-lattice", 5, 5, 4, 4, 1, 1, {}, {{"keep", 1000000}}},
    {"percolated-laves-graph", 4, 4, 3, 3, 1, 1, {}, {{"keep", 1000000}}},
    {"nested-triangles", 13, 12, 21, 0, 1, 3, {{3, 6}, {4, 6}}},
    {"iterated-truncation", 35, 12, 18, 0, 1, 3, {{3, 12}}},
    {"iterated-truncation", 36, 36, 54, 0, 1, 3, {{3, 36}}},
    {"nested-truncation", 15, 14, 21, 0, 1, 3, {{3, 14}}},
    {"nanotube", 20, 20, 30, 0, 1, 3, {{3, 20}}},
    {"nanotube", 40, 36, 54, 0, 1, 3, {{3, 36}}, {{"around", 6}}},
    {"fullerene", 20, 20, 30, 0, 1, 3, {{3, 20}}},
    {"fullerene", 100, 80, 120, 0, 1, kAny, {{3, 80}}},
    {"fullerene", 240, 240, 360, 0, 1, kAny, {{3, 240}}, {{"b", 2}}},
    {"fullerene", 139, 60, 90, 0, 1, 3, {{3, 60}}, {{"b", 1}}},
    {"fullerene", 140, 140, 210, 0, 1, 3, {{3, 140}}, {{"b", 1}}},
    {"i-graph", 22, 22, 33, 0, 1, 3, {{3, 22}}},
    {"i-graph", 24, 24, 36, 0, 2, 0, {{3, 24}}, {{"j", 2}, {"k", 4}}},
    {"blanusa-snark", 18, 18, 27, 0, 1, 3, {{3, 18}}},
    {"blanusa-snark", 26, 26, 39, 0, 1, 3, {{3, 26}}, {{"type", 2}}},
    {"goldberg-snark", 55, 40, 60, 0, 1, 3, {{3, 40}}},
    {"odd-graph", 12, 10, 15, 0, 1, 3, {{3, 10}}},
    {"odd-graph", 40, 35, 70, 0, 1, 4, {{4, 35}}},
    {"named", 1, 10, 15, 0, 1, 3, {{3, 10}}},
    {"random-cubic-bridges", 41, 40, 60, 3, 1, 1, {{3, 40}}},
    {"random-cubic-bridges", 60, 60, 90, 7, 1, 1, {{3, 60}}, {{"bridges", 7}}},
    {"random-cubic-bridges", 30, 30, 45, 0, 1, kAny, {{3, 30}}, {{"bridges", 0}}},
    {"block-chain", 19, 18, 27, 3, 1, 1, {{3, 18}}},
    {"diamond-necklace", 14, 12, 18, 0, 1, 2, {{3, 12}}},
    {"random-cactus", 22, 21, 25, 0, 1, 1, {{2, 17}, {4, 4}}},
    {"contained-cycles", 20, 18, 36, 0, 1, kAny, {{4, 18}}},
    {"mixed-union", 40, 36, 51, 1, 6, 0, {{2, 6}, {3, 30}}},
    {"true-sinks", 15, 14, 20, 0, 2, 0, {{2, 2}, {3, 12}}},
    {"random-connected-cubic", 12, 12, 18, kAny, 1, kAny, {{3, 12}}},
    {"random-connected-4-regular", 12, 12, 24, 0, 1, kAny, {{4, 12}}},
    {"random-bipartite-cubic", 21, 20, 30, 0, kAny, kAny, {{3, 20}}},
    {"random-subcubic", 20, 20, 30, kAny, kAny, kAny, {{3, 20}}, {{"keep", 1000000}}},
};
// clang-format on

class FamilyProperties : public ::testing::TestWithParam<Expectation> {};

TEST_P(FamilyProperties, HoldForSeveralSeeds) {
  const Expectation& expected = GetParam();
  const Family& family = find_family(expected.family);
  for (std::uint64_t seed = 0; seed < (family.is_random ? 5u : 1u); ++seed) {
    const Graph graph = generate(family, expected.requested_n, seed, expected.parameters);
    const auto known = [](std::int64_t told, auto found) {
      return told == kAny ? kAny : static_cast<std::int64_t>(found());
    };
    EXPECT_EQ(graph.num_vertices(), expected.n);
    EXPECT_EQ(known(expected.m, [&] { return graph.num_edges(); }), expected.m);
    EXPECT_EQ(known(expected.bridges, [&] { return bridges(graph); }), expected.bridges);
    EXPECT_EQ(known(expected.components, [&] { return components(graph); }), expected.components);
    EXPECT_EQ(known(expected.connectivity, [&] { return connectivity(graph, 4); }),
              expected.connectivity);
    if (!expected.degrees.empty()) {
      EXPECT_EQ(degree_counts(graph), expected.degrees);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Table, FamilyProperties, ::testing::ValuesIn(kExpectations),
                         [](const auto& test) {
                           std::string name =
                               fmt::format("{}_{}_{}", test.param.family, test.param.n, test.index);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Families, EveryOneIsInTheTable) {
  for (const Family& family : families()) {
    EXPECT_TRUE(std::any_of(kExpectations.begin(), kExpectations.end(),
                            [&](const Expectation& e) { return e.family == family.name; }))
        << family.name << " has no property test";
  }
}

}  // namespace
}  // namespace ar3d::testing
