// The proof by counting against the oracle: the same verdicts, and the same counts as by all pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "ar3d/verify/counting/counting_proof.h"
#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/predicates/exact.h"
#include "ar3d/verify/predicates/functional.h"
#include "verify/counted_pairs.h"
#include "verify/random_drafts.h"

namespace ar3d::testing {
namespace {

using verify::CountingSizes;

/// Every branch runs on small drawings: buckets and bins of a few records, early plane sweeps.
const std::vector<CountingSizes>& sizes() {
  static const std::vector<CountingSizes> list = {{},
                                                  {.bucket = 8, .crowded = 32},
                                                  {.bucket = 64, .crowded = 1},
                                                  {.bucket = 2, .crowded = 0},
                                                  {.bucket = 8, .crowded = 32, .memory = 200},
                                                  {.bucket = 2, .crowded = 1, .memory = 1}};
  return list;
}

std::vector<Vector> directions_of(const Drawing& drawing) {
  std::set<Vector> directions;
  const verify::Segments segments(drawing);
  for (verify::SegmentId s = 0; s < segments.size(); ++s) {
    const Vector d = primitive(segments.direction(s));
    directions.insert(std::max(d, -d));
  }
  return {directions.begin(), directions.end()};
}

/// Every direction is allowed that the drawing has.
CountingOutcome count_by_planes(const Graph& graph, const Drawing& drawing,
                                const CountingSizes& sizes) {
  Guarantee guarantee = no_promise();
  guarantee.directions = directions_of(drawing);
  verify::CountingProof proof(graph, drawing, guarantee, sizes);
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    proof.add(drawing.edge(e), points);
  });
  return {proof.holds(measure(drawing)), proof.counts()};
}

CountingOutcome count_by_planes(const Draft& draft, const CountingSizes& sizes) {
  return count_by_planes(draft.graph(), draft.drawing(), sizes);
}

/// The oracle of the points of Lemma V.3: in how many pairs they are counted.
std::uint64_t meetings_of_points(const Drawing& drawing) {
  const verify::Segments segments(drawing);
  std::vector<std::tuple<Point, Point, Vector>> others;
  std::map<std::pair<bool, std::uint32_t>, std::vector<Vector>> leaving;  // vertices and bends
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) leaving[{false, v}];
  for (verify::SegmentId s = 0; s < segments.size(); ++s) {
    others.emplace_back(segments.from(s), segments.to(s), segments.direction(s));
    const auto [u, v] = drawing.edge(segments.edge(s));
    const bool first = segments.is_first(s), last = segments.is_last(s);
    leaving[{!first, first ? u : s}].push_back(segments.direction(s));
    leaving[{!last, last ? v : s + 1}].push_back(-segments.direction(s));
  }
  std::vector<Vector> directions = directions_of(drawing);
  directions.insert(directions.end(), {{1, 0, 0}, {0, 1, 0}});
  std::uint64_t meetings = 0;
  for (auto& [end, seen] : leaving) {
    const Point p = end.first ? segments.from(end.second) : drawing.vertex(end.second);
    for (const Vector d : directions) {
      const auto differs = [&](Vector e) { return !verify::parallel(seen[0], e); };
      if (std::ranges::any_of(seen, differs)) break;  // two directions
      if (!seen.empty() && !differs(d)) continue;
      meetings += std::ranges::count_if(others, [&](const auto& other) {
        const auto& [from, to, e] = other;
        return !verify::parallel(d, e) && verify::on_segment(p, from, to);
      });
      others.emplace_back(p, p, d);
      seen.push_back(d);
    }
  }
  return meetings;
}

void expect_planes_agree(const Draft& draft, Tally& tally) {
  const bool valid = is_valid(draft);
  ++(valid ? tally.valid : tally.invalid);
  const auto all = count_all_pairs(verify::Segments(draft.drawing()));
  const std::uint64_t crossing = all.crossing + meetings_of_points(draft.drawing());
  for (const CountingSizes& s : sizes()) {
    const CountingOutcome outcome = count_by_planes(draft, s);
    ASSERT_EQ(outcome.proved, valid) << "bucket " << s.bucket;
    if (all.overlap) continue;  // seen before anything is counted, or by the points
    ASSERT_EQ(outcome.counts.found.crossing, crossing);
    tally.more_meetings += crossing > outcome.counts.crossing_neighbours;
  }
}

TEST(Counting, AgreesOnRandomAndDamagedDrawings) {
  RandomDrafts drafts(5, 17);
  Tally tally;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const auto& set = direction_sets()[i % direction_sets().size()];
    const std::vector<Vector> directions(set.begin(), set.begin() + 1 + i / 4 % set.size());
    const Draft draft =
        drafts.damaged(simple(drafts.walks(directions, 1 + i % 9, 4 + i % 23)), i % 3);
    if (!has_low_degrees(draft) || directions_of(draft.drawing()).size() > 16) continue;
    ASSERT_NO_FATAL_FAILURE(expect_planes_agree(draft, tally)) << "drawing " << i;
  }
  EXPECT_GT(tally.valid, 200);
  EXPECT_GT(tally.invalid, 200);
  EXPECT_GT(tally.more_meetings, 200);
}

/// Axis-parallel segments in three planes, long and short, no two of which meet.
Draft crowded_draft(RandomStream& random, std::uint32_t tries, std::uint32_t side) {
  Draft draft;
  std::vector<std::pair<Point, Point>> placed;
  for (std::uint32_t i = 0; i < tries; ++i) {
    const Point from{random.below(side), random.below(side), random.below(3)};
    const std::int64_t length = 1 + random.below(i % 10 == 0 ? side : 5);
    const Point to = from + (random.chance(1, 2) ? Vector{length, 0, 0} : Vector{0, length, 0});
    const bool meets = std::any_of(placed.begin(), placed.end(), [&](const auto& other) {
      return verify::meet(from, to, other.first, other.second).kind != verify::MeetingKind::nothing;
    });
    if (meets) continue;
    placed.emplace_back(from, to);
    const auto v = static_cast<Vertex>(draft.vertices.size());
    draft.vertices.insert(draft.vertices.end(), {from, to});
    draft.edges.push_back({{v, v + 1}, {}});
  }
  return draft;
}

TEST(Counting, SeesOneLongerSegmentInACrowdedPlane) {
  RandomStream random(3, 4);
  int seen = 0;
  for (int i = 0; i < 8; ++i) {
    Draft draft = crowded_draft(random, 900, 110);
    ASSERT_GT(draft.edges.size(), 250u);
    for (const CountingSizes& s : sizes()) ASSERT_TRUE(count_by_planes(draft, s).proved);
    const auto v = 2 * random.below(static_cast<std::uint32_t>(draft.edges.size())) + 1;
    draft.vertices[v] =
        draft.vertices[v] + 60 * primitive(draft.vertices[v] - draft.vertices[v - 1]);
    Tally tally;
    ASSERT_NO_FATAL_FAILURE(expect_planes_agree(draft, tally));
    seen += tally.invalid;
  }
  EXPECT_GE(seen, 4);
}

TEST(Counting, QuadraticallyManyCrossings) {
  Draft draft;
  for (std::int64_t i = 0; i < 300; ++i) {
    const auto v = static_cast<Vertex>(draft.vertices.size());
    draft.vertices.insert(draft.vertices.end(), {{i, -1, 0}, {i, 300, 0}, {-1, i, 0}, {300, i, 0}});
    draft.edges.push_back({{v, v + 1}, {}});
    draft.edges.push_back({{v + 2, v + 3}, {}});
  }
  for (const CountingSizes& s : sizes()) {
    EXPECT_EQ(count_by_planes(draft, s).counts.found.crossing, 90000u + 1200);  // and ends
    EXPECT_FALSE(count_by_planes(draft, s).proved);
  }
}

/// An edge, and a vertex without edges at some place.
Draft with_isolated(Point isolated) {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {8, 4, 0}, isolated};
  draft.edges = {{{0, 1}, {{4, 0, 0}, {4, 4, 0}}}};
  return draft;
}

TEST(Counting, IsolatedVertices) {
  for (const Point on : {Point{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 3, 0}, {4, 4, 0}, {8, 4, 0}}) {
    EXPECT_FALSE(count_by_planes(with_isolated(on), {}).proved) << to_string(on);
  }
  for (const Point off : {Point{9, 4, 0}, {3, 1, 0}, {4, 5, 0}, {-1, 0, 0}, {4, 2, 1}}) {
    EXPECT_TRUE(count_by_planes(with_isolated(off), {}).proved) << to_string(off);
  }
  Draft alone;
  alone.vertices = {{1, 2, 3}, {1, 2, 4}, {0, 2, 3}};
  EXPECT_TRUE(count_by_planes(alone, {}).proved);
  alone.vertices.push_back({1, 2, 4});
  EXPECT_FALSE(count_by_planes(alone, {}).proved);
}

/// A cross of two edges, moved to where the coordinates reach `far`.
Draft cross_at(std::int64_t far, bool meeting) {
  Draft draft;
  const std::int64_t gap = meeting ? 0 : 1;
  draft.vertices = {{far - 4, far - 4, far},
                    {far, far, far},
                    {far - 4, far, far - gap},
                    {far, far - 4, far - gap}};
  draft.edges = {{{0, 1}, {}}, {{2, 3}, {}}};
  return draft;
}

TEST(Counting, WidthsAreKeptOrRefused) {
  // Functionals of these directions have coefficients of sum 2 at most.
  const std::int64_t limit = std::int64_t{1} << 30;
  for (const std::int64_t far : {limit - 1, -limit + 5}) {
    EXPECT_TRUE(count_by_planes(cross_at(far, false), {}).proved) << far;
    EXPECT_FALSE(count_by_planes(cross_at(far, true), {}).proved) << far;
    EXPECT_EQ(count_by_planes(cross_at(far, true), {}).counts.found.crossing, 1u + 4) << far;
  }
  for (const std::int64_t far : {limit, limit + 1, -limit + 3, std::int64_t{1} << 32,
                                 std::int64_t{1} << 61, (std::int64_t{1} << 32) + 10}) {
    EXPECT_FALSE(count_by_planes(cross_at(far, false), {}).proved) << far << ": out of the limits";
    const Draft draft = cross_at(far, false);
    EXPECT_TRUE(
        certify(draft.graph(), draft.drawing(), no_promise(), {.check_size = false}).valid())
        << "the full verifier judges it";
  }
}

TEST(Counting, NeighboursThatOverlapAreNoProof) {
  Draft draft;  // an edge that runs back over itself
  draft.vertices = {{0, 0, 0}, {2, 0, 0}};
  draft.edges = {{{0, 1}, {{5, 0, 0}}}};
  EXPECT_FALSE(count_by_planes(draft, {}).proved);
  draft.edges = {{{0, 1}, {{1, 0, 0}}}};
  EXPECT_TRUE(count_by_planes(draft, {}).proved);
}

TEST(Counting, EdgesMayBeDrawnInAnyOrder) {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  draft.edges = {{{3, 2}, {}}, {{1, 2}, {}}, {{0, 3}, {}}, {{1, 0}, {}}};
  EXPECT_TRUE(count_by_planes(draft, {}).proved);
  draft.edges.push_back({{2, 3}, {{4, 8, 0}, {0, 8, 0}}});  // in place of one that is missing
  draft.edges.erase(draft.edges.begin() + 1);
  const Graph graph(4, {{2, 3}, {1, 2}, {0, 3}, {0, 1}});
  EXPECT_FALSE(certify(graph, draft.drawing(), no_promise()).valid());
}

/// The oracle of SignedDirections::find(): the quotient of each component.
verify::SignedDirections::Found found_by_division(const verify::SignedDirections& directions,
                                                  Vector d) {
  for (std::size_t id = 0; id < 2 * directions.indices(); ++id) {
    const Vector unit = directions.of_id(id);
    const std::size_t axis = verify::leading_axis(unit);
    const std::int64_t steps = verify::component(d, axis) / verify::component(unit, axis);
    if (steps <= 0 || steps * unit != d) continue;
    return {true, static_cast<std::uint8_t>(id), static_cast<std::int32_t>(steps)};
  }
  return {};
}

TEST(Counting, StepsAlongADirectionAreThoseOfADivision) {
  RandomStream random(7, 9);
  const auto below = [&](std::uint32_t n) { return std::int64_t{random.below(n)}; };
  int known = 0, unknown = 0;
  for (int i = 0; i < 400; ++i) {
    verify::SignedDirections directions;
    const std::uint32_t side = i % 2 == 0 ? 13 : 1u << 20;  // no step of 1 in most
    std::vector<Vector> units;
    for (int k = 0; k < 6; ++k) {
      units.push_back({below(side), below(side) - below(side), below(side) - 1});
      if (units.back() == Vector{}) units.back().z = 6;
      directions.add(units.back());
    }
    for (std::size_t k = 0; k < 60; ++k) {
      const std::int64_t steps = below(2047) - 1023;
      Vector d = steps * primitive(units[k % 6]);
      if (k % 4 == 0) d.x += below(3) - 1;
      const auto got = directions.find(d);
      const auto wanted = found_by_division(directions, d);
      ASSERT_EQ(got.known, wanted.known) << to_string(d);
      ++(got.known ? known : unknown);
      if (!got.known) continue;
      ASSERT_EQ(got.id, wanted.id) << to_string(d);
      ASSERT_EQ(got.steps, wanted.steps) << to_string(d);
    }
  }
  EXPECT_GT(known, 10000);
  EXPECT_GT(unknown, 1000);
}

TEST(Counting, AnotherGraphIsNotDrawn) {
  const Drawing drawing = with_isolated({20, 20, 20}).drawing();
  for (const Graph& graph : {Graph(3, {{0, 2}}), Graph(2, {{0, 1}}), Graph(3, {{0, 1}, {1, 2}})}) {
    EXPECT_FALSE(count_by_planes(graph, drawing, {}).proved);
  }
}

}  // namespace
}  // namespace ar3d::testing
