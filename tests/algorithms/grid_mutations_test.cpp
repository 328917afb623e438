// Each rule of algorithm `grid`'s invariant is needed: with one of them broken and the others kept,
// the verifier finds two segments that meet.
#include <array>
#include <cstdlib>
#include <functional>

#include "algorithms/grid_checks.h"
#include "ar3d/algorithms/grid/planes.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

using grid::Planes;

/// Whether the verifier sees two segments that share a point, or a vertex on an edge.
bool meets_itself(const Graph& graph, const Drawing& drawing) {
  const Certificate certificate = certify(graph, drawing, find_algorithm("grid").guarantee);
  return std::ranges::any_of(certificate.violations, [](const Violation& violation) {
    return violation.kind == ViolationKind::crossing ||
           violation.kind == ViolationKind::vertex_on_edge ||
           violation.kind == ViolationKind::same_point;
  });
}

bool is_used(const Planes& planes, grid::Colour c, std::int64_t number) {
  return std::ranges::any_of(planes.of, [&](const auto& x) { return x[c] == number; });
}

/// Rule (I2) at all edges; there are no defects.
bool neighbours_are_far(const Graph& graph, const Planes& planes) {
  return std::ranges::all_of(graph.edges(), [&](const Edge& e) {
    return std::abs(grid::sum_of(planes.of[e.u]) - grid::sum_of(planes.of[e.v])) >= 2;
  });
}

TEST(GridMutations, WithoutDistinctSumsTheVerifierObjects) {
  // (I1) dropped: an edge's plane moves to a number that is free, (I3), and keeps neighbours apart,
  // (I2), but gives one of its ends another vertex's sum. No defects, so (I4) and (I5) say nothing.
  int mutants = 0;
  int broken = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Graph graph = generate(find_family("random-cubic"), 12, seed);
    const Planes planes = planes_of(graph, {});
    if (planes.counts.flat_defects != 0 || planes.counts.core_parts != 0) continue;
    ASSERT_FALSE(meets_itself(graph, drawing_of(graph, planes)));
    for (EdgeId e = 0; e < graph.num_edges(); ++e) {
      const Edge ends = graph.edge(e);
      const grid::Colour c = planes.labels.at(e, ends.u, ends.v);
      for (Vertex other = 0; other < graph.num_vertices(); ++other) {
        if (other == ends.u || other == ends.v) continue;
        const std::int64_t number =
            planes.of[ends.u][c] + grid::sum_of(planes.of[other]) - grid::sum_of(planes.of[ends.u]);
        if (is_used(planes, c, number)) continue;
        Planes moved = planes;
        for (const Vertex v : {ends.u, ends.v}) moved.of[v][c] = grid::narrow(number);
        if (!neighbours_are_far(graph, moved)) continue;
        ASSERT_TRUE(grid::broken_invariant(graph, moved).starts_with("(I1)"));
        ++mutants;
        broken += meets_itself(graph, drawing_of(graph, moved)) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(mutants, 100);
  EXPECT_GT(broken, 0);
}

TEST(GridMutations, WithoutEmptySlotsTheVerifierObjects) {
  // (I5) dropped: move every slot to numbers of its range that are planes of other vertices, or the
  // slots of others.
  int broken = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Graph graph = generate(find_family("random-cubic"), 40, seed);
    const Planes planes = core_planes(graph);
    for (std::size_t i = 0; i < planes.slots.size(); ++i) {
      for (std::int64_t k = planes.slots[i].k - 40; k < planes.slots[i].k; ++k) {
        Planes moved = planes;
        moved.slots[i].k = k;
        const std::string rule = grid::broken_invariant(graph, moved);
        if (rule.find("is not its own") == std::string::npos) continue;
        broken += meets_itself(graph, drawing_of(graph, moved)) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(broken, 0);
}

using Segments4 = std::array<Vector, 4>;  ///< their directions
using Move = std::function<void(const Segments4&, std::vector<Point>& bends)>;

int drawings_that_meet_themselves(const Move& move) {
  int count = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Graph graph = generate(find_family("random-cubic"), 120, seed);
    Draft draft = draft_of(drawing_of(graph, core_planes(graph)));
    for (auto& [ends, bends] : draft.edges) {
      const Point u = draft.vertices[ends.u], v = draft.vertices[ends.v];
      move({primitive(bends[0] - u), primitive(bends[1] - bends[0]), primitive(bends[2] - bends[1]),
            primitive(v - bends[2])},
           bends);
    }
    count += meets_itself(graph, draft.drawing()) ? 1 : 0;
  }
  return count;
}

TEST(GridMutations, WithAWrongResidueOfUEdgesTheVerifierObjects) {
  EXPECT_EQ(drawings_that_meet_themselves([](auto&, auto&) {}), 0);
  const auto longer_last = [](const Segments4& along, std::vector<Point>& bends) {
    if (along[0] != -along[3]) return;
    bends[1] = bends[1] + along[1];
    bends[2] = bends[2] + -along[3];
  };
  EXPECT_GT(drawings_that_meet_themselves(longer_last), 0);
}

TEST(GridMutations, WithAWrongOffsetTheVerifierObjects) {
  const auto longer_first = [](const Segments4& along, std::vector<Point>& bends) {  // E < 0
    for (const std::size_t i : {0, 1}) {
      if (along[0] == along[2]) bends[i] = bends[i] + along[0];
      if (along[1] == along[3]) bends[i + 1] = bends[i + 1] + -along[3];
    }
  };
  EXPECT_GT(drawings_that_meet_themselves(longer_first), 0);
}

}  // namespace
}  // namespace ar3d::testing
