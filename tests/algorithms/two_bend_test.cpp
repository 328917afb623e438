#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

#include "algorithms/two_bend_graphs.h"
#include "algorithms/two_bend_support.h"
#include "ar3d/verify/metrics/metrics.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

TEST(TwoBend, DrawsFamiliesOfEverySmallKind) {
  for (Vertex n = 0; n < 5; ++n) expect_certified(Graph(n, {}));
  for (Vertex n = 2; n < 9; ++n) expect_certified(path(n));
  for (Vertex n = 3; n < 12; ++n) expect_certified(cycle(n));
  expect_certified(complete(4));
  expect_certified(petersen());
  expect_certified(disjoint_union({complete(4), path(1), petersen(), cycle(5), path(2)}));
}

/// The whole variety of vertex types, specials and fixed bodies is met and certified.
TEST(TwoBend, MeetsEveryPartOfTheConstruction) {
  std::map<std::string, std::int64_t> totals;
  const auto draw_and_count = [&](const Graph& graph) {
    for (const Counter& counter : expect_certified(graph)) totals[counter.name] += counter.value;
  };
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    draw_and_count(shuffled(random_graph_of_any_kind(24, seed), seed));
  }
  for (const Graph& graph : geng("-c -d3 -D3 10")) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) draw_and_count(shuffled(graph, seed));
  }
  for (const char* part : {"q_bodies", "stations", "vv_leans", "sinks_a", "sinks_v", "sources_a",
                           "sources_v", "adjacent_poles"}) {
    EXPECT_GT(totals[part], 0) << part;
  }
  EXPECT_EQ(totals["safe_rounds"], 0);
}

TEST(TwoBend, DrawsEveryFamilyOfTheCatalogue) { expect_families_certified({6, 20, 64, 150}); }

/// In parts of n x n x n^2.
double volume_of(const Drawing& drawing) {
  const double n = static_cast<double>(drawing.num_vertices());
  const auto [x, y, z] = bounding_box(drawing).extents();
  return static_cast<double>(x) / n * (static_cast<double>(y) / n) *
         (static_cast<double>(z) / n / n);
}

TEST(TwoBend, EffortSavesBendsAndVolume) {
  std::array<std::uint64_t, 2> bends{};
  std::array<double, 2> volume{};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Graph graph = generate(find_family("random-cubic"), 400, seed);
    for (const int effort : {0, 1}) {
      expect_certified(graph, {.effort = effort});
      const Drawing drawing = two_bend::draw(graph, {.effort = effort});
      bends[static_cast<std::size_t>(effort)] += count_bends(drawing);
      volume[static_cast<std::size_t>(effort)] += volume_of(drawing);
    }
  }
  EXPECT_LT(bends[1], bends[0] * 9 / 10);
  EXPECT_LT(volume[1], volume[0]);
}

/// The goal for random cubic graphs is a volume of at most n^4 / 2; 0.26 to 0.29 was met.
TEST(TwoBend, KeepsTheVolumeOfRandomCubicGraphsBelowAThirdOfN4) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Graph graph = generate(find_family("random-cubic"), 10000, seed);
    EXPECT_LT(volume_of(two_bend::draw(graph)), 0.33) << seed;
  }
}

/// Vertices of degree 1 and 2 take the bends of their edge.
TEST(TwoBend, LowDegreesCostHardlyABend) {
  EXPECT_LE(count_bends(two_bend::draw(cycle(30))), 4u);  // at the STATION
  const Graph tree = generate(find_family("binary-tree"), 1000, 1);
  const std::vector<std::uint64_t> edges = measure(two_bend::draw(tree)).bend_histogram;
  EXPECT_GE(edges.at(0), 500u);  // the leaves' edges
  EXPECT_LE(edges.at(2), 40u);
}

TEST(TwoBend, IsDeterministic) {
  const Graph graph = random_graph_of_any_kind(60, 5);
  EXPECT_EQ(drawing_hash(two_bend::draw(graph)), drawing_hash(two_bend::draw(graph)));
}

TEST(TwoBend, RefusesDegree4AndUnknownEfforts) {
  EXPECT_THROW(two_bend::draw(octahedron()), InputError);
  EXPECT_THROW(draw(find_algorithm("two-bend"), complete(5)), InputError);
  EXPECT_THROW(two_bend::draw(path(3), {.effort = 2}), InputError);
  EXPECT_THROW(two_bend::draw(path(3), {.effort = -1}), InputError);
}

/// The drawing with the lower end of the lean of one edge a step higher; nothing if it has no lean.
std::optional<Drawing> with_a_flatter_lean(const Drawing& drawing, EdgeId spoilt) {
  Draft draft = draft_of(drawing);
  std::vector<Point>& bends = draft.edges[spoilt].bends;
  if (bends.size() != 2) return std::nullopt;
  const Vector lean = bends[1] - bends[0];
  if (lean.x == 0 || lean.y == 0) return std::nullopt;
  ++bends[lean.z > 0 ? 0 : 1].z;
  return draft.drawing();
}

/// Leans are as low as Lemmas 2.2 and 2.3 allow: one step less, and an angle is too sharp.
TEST(TwoBend, VerifierSeesEveryLeanThatIsTooLow) {
  const Graph graph = generate(find_family("random-cubic"), 40, 1);
  const Drawing drawing = two_bend::draw(graph);
  std::size_t leans = 0;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const std::optional<Drawing> spoilt = with_a_flatter_lean(drawing, e);
    if (!spoilt) continue;
    ++leans;
    const Certificate certificate = certify(graph, *spoilt, find_algorithm("two-bend").guarantee);
    const auto is_sharp = [](const Violation& violation) {
      return violation.kind == ViolationKind::bend_angle ||
             violation.kind == ViolationKind::vertex_angle;
    };
    EXPECT_TRUE(std::any_of(certificate.violations.begin(), certificate.violations.end(), is_sharp))
        << "edge " << e;
  }
  EXPECT_GT(leans, 5u);
}

}  // namespace
}  // namespace ar3d::testing
