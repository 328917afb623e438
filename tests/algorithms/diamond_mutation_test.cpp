// Breaking any rule of Theorem 1's construction must show in the certificate: the rules are needed,
// and the verifier sees them.
#include "algorithms/diamond_support.h"
#include "ar3d/algorithms/diamond/guaranteed.h"
#include "ar3d/algorithms/diamond/parity.h"
#include "ar3d/algorithms/diamond/routes.h"
#include "support/graphs.h"

namespace ar3d::testing {
namespace {

using namespace diamond;

Certificate judge(const Graph& graph, const Placement& placement, Tracks tracks) {
  return certify(graph, lift(graph, placement, std::move(tracks)), diamond::row().guarantee,
                 {.crossing_test = CrossingTest::all_pairs, .check_size = false});
}

bool has(const Certificate& certificate, ViolationKind kind) {
  return std::any_of(certificate.violations.begin(), certificate.violations.end(),
                     [kind](const Violation& v) { return v.kind == kind; });
}

/// One green edge between (0, 0) and (X, Y).
struct OneEdge {
  Graph graph{2, {{0, 1}}};
  Placement placement;
  OneEdge(std::int32_t X, std::int32_t Y) {
    placement.green = {{0, 1}, {0, kNone}, {0, 2}};
    placement.red = {{0, 1}, {kNone, kNone}, {0, 1, 2}};
    placement.at = {{0, 0}, {X, Y}};
  }
  Certificate judge(std::int32_t track) const {
    return testing::judge(graph, placement, {{2 * track}, {}});
  }
};

TEST(DiamondMutation, EqualDistancesPutTheApexOfAUOnATurn) {
  EXPECT_TRUE(OneEdge(2, 4).judge(5).valid());
  EXPECT_FALSE(keeps_invariants(OneEdge(4, 4).graph, OneEdge(4, 4).placement));
  for (const std::int32_t track : {5, 9, -1}) {
    EXPECT_TRUE(has(OneEdge(4, 4).judge(track), ViolationKind::degenerate_segment) ||
                has(OneEdge(4, 4).judge(track), ViolationKind::bend_angle))
        << track;
  }
}

TEST(DiamondMutation, ThePapersTrackAtDistanceOneCanPutTheApexOfAZOnATurn) {
  // |dY| = 4, |dX| = 2: tracks at distance 1 from either end fail, distance 2 works.
  EXPECT_FALSE(OneEdge(2, 4).judge(1).valid());
  EXPECT_FALSE(OneEdge(2, 4).judge(3).valid());
  EXPECT_TRUE(OneEdge(2, 4).judge(2).valid());
}

TEST(DiamondMutation, OddLengthsLeaveTheLattice) {
  EXPECT_FALSE(keeps_invariants(OneEdge(1, 4).graph, OneEdge(1, 4).placement));
  EXPECT_FALSE(OneEdge(1, 4).judge(5).valid());
}

/// A drawing of a 4-regular graph: every vertex has all four ends, so that no colour or label is
/// free.
struct Drawn {
  Graph graph = shuffled(disjoint_union({complete(5), octahedron(), complete(5)}), 3);
  Placement placement;
  Tracks tracks;
  Drawn() {
    const PaddedNeighbours neighbours = padded_neighbours(graph);
    const TwoColouring colours = two_colouring(graph, neighbours, balanced_orientation(neighbours));
    placement =
        place_guaranteed(graph, extract_items(colours[kGreen]), extract_items(colours[kRed])).first;
    tracks = choose_tracks(graph, placement);
  }
};

TEST(DiamondMutation, TheUnbrokenDrawingIsValid) {
  const Drawn drawn;
  EXPECT_TRUE(judge(drawn.graph, drawn.placement, drawn.tracks).valid());
}

TEST(DiamondMutation, EveryFlippedColourShows) {
  const Drawn drawn;
  for (EdgeId e = 0; e < drawn.graph.num_edges(); ++e) {
    Tracks tracks = drawn.tracks;
    tracks.code[e] ^= 1;
    EXPECT_FALSE(judge(drawn.graph, drawn.placement, tracks).valid()) << "edge " << e;
  }
}

TEST(DiamondMutation, EveryEdgeOnTheWrongSideShowsWhereItMeetsAnotherOfItsColour) {
  // Mirroring a track at its edge's middle flips the labels of both ends.
  const Drawn drawn;
  for (const Items* items : {&drawn.placement.green, &drawn.placement.red}) {
    const bool green = items == &drawn.placement.green;
    for (std::size_t p = 0; p + 1 < items->vertex.size(); ++p) {
      const EdgeId e = items->edge[p];
      if (e == kNone || p == 0 || items->edge[p - 1] == kNone)
        continue;  // needs two edges of the colour at its start
      const auto [u, v] = drawn.graph.edge(e);
      const auto b = [&](Vertex w) {
        return green ? drawn.placement.at[w].Y : drawn.placement.at[w].X;
      };
      Tracks tracks = drawn.tracks;
      const std::int32_t track = tracks.code[e] >> 1;
      tracks.code[e] = 2 * (b(u) + b(v) - track) + (green ? 0 : 1);
      if (tracks.code[e] == drawn.tracks.code[e]) continue;
      if ((track > b(u)) == (track < b(v))) continue;  // a Z: both tracks may be right
      EXPECT_FALSE(judge(drawn.graph, drawn.placement, tracks).valid()) << "edge " << e;
    }
  }
}

TEST(DiamondMutation, SwappedVerticesShow) {
  const Drawn drawn;
  for (Vertex v = 1; v < drawn.graph.num_vertices(); ++v) {
    Placement placement = drawn.placement;
    std::swap(placement.at[0], placement.at[v]);
    EXPECT_FALSE(judge(drawn.graph, placement, drawn.tracks).valid()) << "vertex " << v;
  }
}

}  // namespace
}  // namespace ar3d::testing
