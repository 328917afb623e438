// The families built to hurt an algorithm do: how often each meets its special cases there, and
// that other families of the same size do not lead it there.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <tuple>
#include <utility>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/diamond/guaranteed.h"
#include "ar3d/algorithms/diamond/routes.h"
#include "ar3d/generators/catalog.h"
#include "support/counters.h"

namespace ar3d::testing {
namespace {

/// What the construction of Theorem 1 in its guaranteed mode meets.
struct DiamondCases {
  diamond::GapCount gaps;
  std::int64_t midpoint_z =
      0;  ///< edges drawn as Z with |dY| = 4 and |dX| = 2: no track at distance 1
};

DiamondCases diamond_cases(const Graph& graph) {
  using namespace diamond;
  const PaddedNeighbours neighbours = padded_neighbours(graph);
  const TwoColouring colours = two_colouring(graph, neighbours, balanced_orientation(neighbours));
  const auto [placement, gaps] =
      place_guaranteed(graph, extract_items(colours[kGreen]), extract_items(colours[kRed]));
  const Tracks tracks = choose_tracks(graph, placement);
  DiamondCases cases{gaps};
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const PlanePoint p = placement.at[graph.edge(e).u];
    const PlanePoint q = placement.at[graph.edge(e).v];
    const bool red = (tracks.code[e] & 1) == kRed;
    const std::int32_t track = tracks.code[e] >> 1;
    const auto [along, from, to] =
        red ? std::tuple{std::abs(p.Y - q.Y), p.X, q.X} : std::tuple{std::abs(p.X - q.X), p.Y, q.Y};
    const bool between = (track > from) != (track > to);
    if (between && along == 2 && std::abs(from - to) == 4) ++cases.midpoint_z;
  }
  return cases;
}

std::int64_t counter(const std::string& algorithm, const Graph& graph, int effort,
                     const std::string& name) {
  return counter_of(draw(find_algorithm(algorithm), graph, {{"effort", effort}}), name);
}

/// Number of vertices, and whether the labels are shuffled.
class HardFamilies : public ::testing::TestWithParam<std::pair<std::uint64_t, bool>> {
 protected:
  Graph member(const std::string& family) const {
    const auto [n, shuffled] = GetParam();
    return generate(find_family(family), n, 7, {{"shuffle", shuffled ? 1 : 0}});
  }
};

/// With the family's labels every triangle is a green cycle inside the red cycle, cannot be closed
/// at every edge, and takes a Z whose track has to be in the middle; with shuffled ones many do.
TEST_P(HardFamilies, ContainedCyclesAreContainedAndNeedTheMiddleTrack) {
  const Graph graph = member("contained-cycles");
  const std::int64_t triangles = graph.num_vertices() / 3;
  const DiamondCases cases = diamond_cases(graph);
  const bool shuffled = GetParam().second;
  EXPECT_GE(cases.gaps.contained, shuffled ? triangles / 4 : triangles);
  // Where the red cycle begins, a distance may differ.
  EXPECT_GE(cases.midpoint_z, shuffled ? triangles / 4 : triangles - 2);
  if (!shuffled) {
    EXPECT_EQ(cases.gaps.rho, 1);
  }
}

/// Contained cycles, and, where the labels are the family's own, a red cycle a component that must
/// be widened: H = n/6.
TEST_P(HardFamilies, OctahedraCostDiamondLines) {
  const Graph graph = member("union-octahedron");
  const std::int64_t components = graph.num_vertices() / 6;
  const DiamondCases cases = diamond_cases(graph);
  EXPECT_GT(cases.gaps.contained, components / 4);
  EXPECT_GE(cases.midpoint_z, 3 * components / 2);
  const bool shuffled = GetParam().second;
  if (!shuffled) {
    EXPECT_EQ(cases.gaps.contained, 2 * components);
    EXPECT_EQ(cases.gaps.bumps, components);
    EXPECT_EQ(cases.gaps.H(), components);
    EXPECT_EQ(cases.midpoint_z, 2 * components);
  }
}

TEST_P(HardFamilies, RandomGraphsHardlyMeetTheCasesOfDiamond) {
  const DiamondCases cases = diamond_cases(member("random-4-regular"));
  EXPECT_LE(cases.gaps.contained, 3);
  EXPECT_LE(cases.midpoint_z, 3);
}

/// Of the six components of a round, the one with a bridge and the Petersen graph have no
/// 3-edge-colouring. Such a cubic graph stays without one when a single edge is removed, so each
/// has two defects at least, and an algorithm that minimises them can do no better.
TEST_P(HardFamilies, MixedUnionHasDefectsAtEveryEffort) {
  const Graph graph = member("mixed-union");
  const std::int64_t rounds = graph.num_vertices() / 36;
  const Graph random = member("random-cubic");
  EXPECT_EQ(counter("grid", graph, 1, "core_parts"), 0);
  EXPECT_GE(counter("grid", graph, 1, "flat_defects"), 4 * rounds);
  EXPECT_LE(counter("grid", random, 1, "flat_defects"), rounds);
  EXPECT_EQ(counter("grid", graph, 0, "core_parts"), 6 * rounds);
  for (const char* special : {"nt", "pq"})
    EXPECT_GT(counter("grid", graph, 0, special), rounds / 2) << special;
  const bool shuffled = GetParam().second;
  EXPECT_GE(counter("grid", graph, 0, "last_u"), 2 * rounds);
  EXPECT_GE(counter("grid", graph, 0, "last_m"), shuffled ? rounds / 2 : 2 * rounds);
}

TEST_P(HardFamilies, SnarkUnionsHaveTwoDefectsInEveryComponent) {
  for (const auto& [family, size] :
       {std::pair{"union-petersen", 10}, std::pair{"union-flower-snark", 20}}) {
    const Graph graph = member(family);
    EXPECT_EQ(counter("grid", graph, 1, "flat_defects"), 2 * (graph.num_vertices() / size))
        << family;
  }
}

/// Every component begins at its only vertex of degree 2, hence with no source, and ends in a sink;
/// a connected graph of any size has one sink.
TEST_P(HardFamilies, TrueSinksEndsEveryComponentInASink) {
  const Graph graph = member("true-sinks");
  const std::int64_t components = graph.num_vertices() / 7;
  const Graph single = member("random-connected-cubic");
  for (const int effort : {0, 1}) {
    const auto sinks = [&](const Graph& g) {
      return counter("two-bend", g, effort, "sinks_a") + counter("two-bend", g, effort, "sinks_v");
    };
    EXPECT_EQ(sinks(graph), components);
    EXPECT_EQ(counter("two-bend", graph, effort, "sources_a"), 0);
    EXPECT_EQ(counter("two-bend", graph, effort, "sources_v"), 0);
    EXPECT_LE(sinks(single), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, HardFamilies,
                         ::testing::Values(std::pair{72, false}, std::pair{72, true},
                                           std::pair{720, false}, std::pair{720, true},
                                           std::pair{7200, false}, std::pair{7200, true}),
                         [](const auto& info) {
                           return fmt::format("n{}{}", info.param.first,
                                              info.param.second ? "_shuffled" : "");
                         });

}  // namespace
}  // namespace ar3d::testing
