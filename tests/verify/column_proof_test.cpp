// The proof by counting in columns against the oracle: the same verdicts, and the same counts as by
// all pairs.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/counting/counting_proof.h"
#include "ar3d/verify/examination.h"
#include "ar3d/verify/predicates/exact.h"
#include "verify/counted_pairs.h"
#include "verify/random_drafts.h"

namespace ar3d::testing {
namespace {

using verify::ColumnProof;
using verify::MeetingCounts;

CountingOutcome count_by_columns(const Draft& draft, const Guarantee& guarantee = no_promise(),
                                 std::size_t patience = 10000) {
  const Graph graph = draft.graph();
  const Drawing drawing = draft.drawing();
  ColumnProof proof(graph, drawing, guarantee, patience);
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    proof.add(drawing.edge(e), points);
  });
  const bool proved = proof.holds();
  return {proved, proof.counts()};
}

/// Sets in which one direction is vertical and the others lie over short and long rows of places,
/// over none, and over each other.
const std::vector<std::vector<Vector>>& tall_sets() {
  static const std::vector<std::vector<Vector>> sets = {
      {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 2, 1}},
      {{0, 0, 1}, {1, 1, 0}, {1, 0, 0}, {1, -2, 2}},
      {{0, 0, 1}, {0, 0, 1}, {1, 0, 2}, {2, 1, 0}},
      {{1, 0, 1}, {1, 1, 1}, {0, 1, 2}, {1, 1, -1}},
      {{0, 0, 1}}};
  return sets;
}

/// Leans of all directions inside edges whose ends stay as they are.
void lean(RandomDrafts& drafts, Draft& draft) {
  for (auto& edge : draft.edges) {
    if (edge.bends.size() < 2 || drafts.random().chance(1, 2)) continue;
    auto& bend = edge.bends[drafts.random().below(static_cast<std::uint32_t>(edge.bends.size()))];
    bend.z += drafts.random().below(5);
  }
}

void expect_columns_agree(const Draft& draft, Tally& tally) {
  const bool valid = is_valid(draft);
  const CountingOutcome outcome = count_by_columns(draft);
  ASSERT_EQ(outcome.proved, valid);
  tally.valid += valid;
  tally.invalid += !valid;
  ASSERT_EQ(count_by_columns(draft, no_promise(), 0).proved, valid) << "by halving space";
  const MeetingCounts all = count_all_pairs(verify::Segments(draft.drawing()));
  const bool has_isolated = without_isolated(draft).vertices.size() < draft.vertices.size();
  if (all.overlap || has_isolated) return;  // nothing more is counted, or more
  ASSERT_EQ(outcome.counts.found.crossing, all.crossing);
  ASSERT_EQ(outcome.counts.found.touching, all.touching);
  ++tally.counted;
  tally.more_meetings += all.crossing > outcome.counts.crossing_neighbours;
}

TEST(ColumnProof, AgreesOnRandomAndDamagedDrawings) {
  RandomDrafts drafts(11, 23);
  Tally tally;
  for (std::uint32_t i = 0; i < 6000; ++i) {
    const auto& set = tall_sets()[i % tall_sets().size()];
    Draft draft = simple(drafts.walks(set, 1 + i % 9, 3 + i % 17));
    if (i % 2 == 0) lean(drafts, draft);
    draft = drafts.damaged(std::move(draft), i % 3);
    if (i % 4 != 0) draft = without_isolated(std::move(draft));
    if (!has_low_degrees(draft)) continue;
    ASSERT_NO_FATAL_FAILURE(expect_columns_agree(draft, tally)) << "drawing " << i;
  }
  EXPECT_GT(tally.valid, 500);
  EXPECT_GT(tally.invalid, 500);
  EXPECT_GT(tally.counted, 1000);
  EXPECT_GT(tally.more_meetings, 200);
}

/// Verticals in a forest of columns, and slanted segments of all lengths through it; none overlap.
Draft forest(RandomStream& random, std::int64_t side, std::uint32_t slanted) {
  Draft draft;
  const auto add = [&](Point from, Point to) {
    for (std::size_t i = 0; i < draft.vertices.size(); i += 2) {
      const auto meeting = verify::meet(from, to, draft.vertices[i], draft.vertices[i + 1]);
      if (meeting.kind == verify::MeetingKind::overlap) return;
    }
    const auto v = static_cast<Vertex>(draft.vertices.size());
    draft.vertices.insert(draft.vertices.end(), {from, to});
    draft.edges.push_back({{v, v + 1}, {}});
  };
  const auto below = [&](std::int64_t limit) {
    return static_cast<std::int64_t>(random.below(static_cast<std::uint32_t>(limit)));
  };
  for (std::int64_t i = 0; i < side * side / 2; ++i) {
    const std::int64_t z = 7 * below(9);
    const Point p{below(side), below(side), z};
    add(p, p + Vector{0, 0, 1 + below(5)});
  }
  static const std::vector<Vector> steps = {{1, 0, 0},  {0, 1, 1}, {1, 1, 2},  {1, -2, 0},
                                            {2, -1, 1}, {1, 0, 2}, {-1, 1, 1}, {2, 2, 1}};
  for (std::uint32_t i = 0; i < slanted; ++i) {
    const Vector d = steps[random.below(static_cast<std::uint32_t>(steps.size()))];
    const Point p{below(side), below(side), below(60)};
    add(p, p + (1 + below(side)) * d);
  }
  return draft;
}

TEST(ColumnProof, CountsMeetingsInAForestOfColumns) {
  RandomStream random(5, 6);
  std::uint64_t meetings = 0;
  for (int i = 0; i < 60; ++i) {
    const Draft draft = forest(random, 4 + i % 20, 120);
    const MeetingCounts all = count_all_pairs(verify::Segments(draft.drawing()));
    const CountingOutcome outcome = count_by_columns(draft);
    ASSERT_FALSE(all.overlap);
    ASSERT_EQ(outcome.counts.found.crossing, all.crossing) << i;
    ASSERT_EQ(outcome.counts.found.touching, all.touching) << i;
    meetings += all.crossing;
  }
  EXPECT_GT(meetings, 1000u);
}

/// A vertical edge of three segments, met by an edge with an end at (0, 0, z).
Draft vertical_and(Point from, Point to) {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {0, 0, 9}, from, to};
  draft.edges = {{{0, 1}, {{0, 0, 2}, {0, 0, 5}}}, {{2, 3}, {}}};
  return draft;
}

TEST(ColumnProof, HeightsBetweenLatticePoints) {
  EXPECT_FALSE(
      count_by_columns(vertical_and({-1, 0, 9}, {2, 0, 8})).proved);  // over the column at 8 2/3
  EXPECT_TRUE(count_by_columns(vertical_and({-1, 0, 10}, {1, 0, 9})).proved);   // at 9 1/2
  EXPECT_TRUE(count_by_columns(vertical_and({-1, 0, -1}, {1, 0, 0})).proved);   // at -1/2
  EXPECT_FALSE(count_by_columns(vertical_and({-1, 0, -1}, {1, 0, 1})).proved);  // at 0
  EXPECT_EQ(count_by_columns(vertical_and({-1, -1, 4}, {1, 1, 6})).counts.found.crossing,
            2u);  // in a bend
  EXPECT_EQ(count_by_columns(vertical_and({-3, -1, 4}, {3, 1, 5})).counts.found.crossing, 1u);
  EXPECT_TRUE(count_by_columns(vertical_and({-3, -2, 4}, {3, 1, 5})).proved);
}

TEST(ColumnProof, IsolatedVertices) {
  for (const Point on :
       {Point{0, 0, 0}, {0, 0, 1}, {0, 0, 5}, {0, 0, 9}, {2, 3, 4}, {3, 3, 4}, {4, 3, 4}}) {
    Draft draft = vertical_and({2, 3, 4}, {4, 3, 4});
    draft.vertices.push_back(on);
    EXPECT_FALSE(count_by_columns(draft).proved) << to_string(on);
  }
  for (const Point off : {Point{0, 0, -1}, {0, 0, 10}, {1, 0, 5}, {3, 3, 5}, {5, 3, 4}}) {
    Draft draft = vertical_and({2, 3, 4}, {4, 3, 4});
    draft.vertices.push_back(off);
    EXPECT_TRUE(count_by_columns(draft).proved) << to_string(off);
    draft.vertices.push_back(off);
    EXPECT_FALSE(count_by_columns(draft).proved) << "two at " << to_string(off);
  }
}

TEST(ColumnProof, WidthsAreKeptOrRefused) {
  const std::int64_t limit = std::int64_t{1} << 30;
  const auto moved = [](Draft draft, Vector by) {
    for (Point& p : draft.vertices) p = p + by;
    for (auto& edge : draft.edges) {
      for (Point& p : edge.bends) p = p + by;
    }
    return draft;
  };
  const Draft apart = vertical_and({-1, 0, 10}, {1, 0, 9});
  const Draft meeting = vertical_and({-1, 0, 9}, {2, 0, 8});
  for (const Vector by : {Vector{limit - 3, limit - 1, kMaxCoordinate - 10},
                          Vector{2 - limit, 1 - limit, -kMaxCoordinate}}) {
    EXPECT_TRUE(count_by_columns(moved(apart, by)).proved);
    EXPECT_FALSE(count_by_columns(moved(meeting, by)).proved);
    EXPECT_EQ(count_by_columns(moved(meeting, by)).counts.found.crossing, 1u);
  }
  EXPECT_FALSE(count_by_columns(moved(apart, {limit - 1, 0, 0})).proved);
  EXPECT_FALSE(count_by_columns(moved(apart, {0, -limit, 0})).proved);
  // As steep and as long as limits allow: the height over the column is a quotient of 93 bits.
  Draft steep = vertical_and({-limit + 1, 0, -kMaxCoordinate}, {limit - 1, 0, kMaxCoordinate});
  EXPECT_EQ(count_by_columns(steep).counts.found.crossing, 1u);
  steep.vertices[2].z += 1;  // the height is 1/2
  EXPECT_EQ(count_by_columns(steep).counts.found.crossing, 1u);
  steep.vertices[2].z = -kMaxCoordinate + 19;
  EXPECT_EQ(count_by_columns(steep).counts.found.crossing, 0u) << "at 9 1/2";
}

TEST(ColumnProof, ManyAtOneHeight) {
  Draft draft;
  for (std::int64_t i = 0; i < 100; ++i) {
    draft.vertices.insert(draft.vertices.end(), {{3 * i, 0, 0}, {3 * i + 1, 1, 0}});
    draft.edges.push_back({{static_cast<Vertex>(2 * i), static_cast<Vertex>(2 * i + 1)}, {}});
  }
  for (const std::size_t patience : {50u, 49u, 0u}) {  // upwards, then by halving space
    EXPECT_TRUE(count_by_columns(draft, no_promise(), patience).proved);
  }
  EXPECT_TRUE(is_valid(draft));
  draft.vertices[151] = draft.vertices[13];
  draft.vertices[151].x += 2;
  ASSERT_FALSE(is_valid(draft));
  for (const std::size_t patience : {50u, 49u, 0u}) {
    EXPECT_FALSE(count_by_columns(draft, no_promise(), patience).proved);
  }
}

/// The drawings themselves, and with a coordinate of one bend or vertex changed by one.
TEST(ColumnProof, ProvesTwoBendDrawingsAndNoDamagedOnes) {
  const Algorithm& algorithm = find_algorithm("two-bend");
  RandomStream random(8, 9);
  int damaged = 0;
  for (const char* name :
       {"random-cubic", "cubic-tree", "honeycomb", "path", "union-k4", "nanotube"}) {
    const Family& family = find_family(name);
    const Graph graph = generate(family, family.nearest_n(200, complete_parameters(family, {})), 1);
    const Drawing drawing = draw(algorithm, graph);
    const Draft draft = draft_of(drawing);
    ASSERT_TRUE(count_by_columns(draft, algorithm.guarantee, 200).proved) << name;
    for (int i = 0; i < 80; ++i) {
      Draft broken = draft;
      auto& edge = broken.edges[random.below(static_cast<std::uint32_t>(broken.edges.size()))];
      Point& p = edge.bends.empty() ? broken.vertices[edge.ends.u] : edge.bends.front();
      std::int64_t& c = i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z;
      c += random.chance(1, 2) ? 1 : -1;
      const bool valid = is_valid(broken, algorithm.guarantee);
      ASSERT_EQ(count_by_columns(broken, algorithm.guarantee, 200).proved, valid) << name << i;
      damaged += !valid;
    }
  }
  EXPECT_GT(damaged, 150);
}

}  // namespace
}  // namespace ar3d::testing
