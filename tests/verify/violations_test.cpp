// For each kind of violation a valid drawing is broken, and the verifier must name exactly that
// kind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "ar3d/verify/certificate.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The promises of Theorem 1, with room for the drawings below.
Guarantee promise() {
  Guarantee guarantee;
  guarantee.max_degree = 4;
  guarantee.max_bends = 3;
  guarantee.cosine = {-1, 3};
  guarantee.lattice = kCubeLattice;
  guarantee.directions = {{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
  guarantee.vertices_in_plane = true;
  const AxisBound bound = linear(4);
  guarantee.bound = {"test", "test", {bound, bound, bound}};
  return guarantee;
}

/// A star of four edges with one bend each, and two isolated vertices:
///
///     3       1    z = 0 at the vertices; the bends are at height
///       .   .      +4 towards 1 and 4, -4 towards 2 and 3
///         0
///       .   .
///     4       2
Draft star() {
  Draft draft;
  draft.vertices = {{0, 0, 0},   {8, 8, 0},  {8, -8, 0}, {-8, 8, 0},
                    {-8, -8, 0}, {10, 0, 0}, {12, 0, 0}};
  draft.edges = {{{0, 1}, {{4, 4, 4}}},
                 {{0, 2}, {{4, -4, -4}}},
                 {{3, 0}, {{-4, 4, -4}}},
                 {{0, 4}, {{-4, -4, 4}}}};
  return draft;
}

class Violations : public ::testing::TestWithParam<CrossingTest> {
 protected:
  Certificate judge(const Graph& graph, const Draft& draft, const Guarantee& guarantee) const {
    CertifyOptions options;
    options.crossing_test = GetParam();
    return certify(graph, draft.drawing(), guarantee, options);
  }
  Certificate judge(const Draft& draft) const { return judge(draft.graph(), draft, promise()); }
};

std::set<std::string> kinds(const Certificate& certificate) {
  std::set<std::string> names;
  for (const Violation& violation : certificate.violations) names.insert(to_string(violation.kind));
  return names;
}

TEST_P(Violations, NoneInAValidDrawing) {
  const Certificate certificate = judge(star());
  EXPECT_THAT(kinds(certificate), ElementsAre());
  EXPECT_TRUE(certificate.valid());
  EXPECT_TRUE(certificate.complete);
  EXPECT_EQ(certificate.segments, 8u);
  EXPECT_EQ(certificate.box, (Box{{-8, -8, -4}, {12, 8, 4}}));
  EXPECT_THAT(certificate.bend_histogram, ElementsAre(0, 4));
}

TEST_P(Violations, NoneInAnEmptyDrawing) { EXPECT_TRUE(judge(Draft{}).valid()); }

TEST_P(Violations, VertexCount) {
  Draft draft = star();
  const Graph graph = draft.graph();
  draft.vertices.push_back({0, 5, 0});
  EXPECT_THAT(kinds(judge(graph, draft, promise())), ElementsAre("vertex_count"));
}

TEST_P(Violations, MissingEdge) {
  Draft draft = star();
  const Graph graph = draft.graph();
  draft.edges.erase(draft.edges.begin() + 2);
  const Certificate certificate = judge(graph, draft, promise());
  EXPECT_THAT(kinds(certificate), ElementsAre("edge_set"));
  ASSERT_EQ(certificate.violations.size(), 1u);
  EXPECT_THAT(certificate.violations[0].vertices, ElementsAre(0, 3));
  EXPECT_EQ(certificate.violations[0].message, "the graph's edge 2 (0-3) is not drawn");
}

TEST_P(Violations, ExtraEdge) {
  Draft draft = star();
  Draft smaller = draft;
  smaller.edges.pop_back();
  const Certificate certificate = judge(smaller.graph(), draft, promise());
  EXPECT_THAT(kinds(certificate), ElementsAre("edge_set"));
  ASSERT_EQ(certificate.violations.size(), 1u);
  EXPECT_THAT(certificate.violations[0].edges, ElementsAre(3));
}

TEST_P(Violations, EdgeDrawnTwice) {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {8, 8, 0}};
  draft.edges = {{{0, 1}, {{4, 4, 4}}}};
  const Graph graph = draft.graph();
  draft.edges.push_back({{1, 0}, {{8, 0, 0}}});
  const Certificate certificate = judge(graph, draft, no_promise());
  EXPECT_THAT(kinds(certificate), ElementsAre("edge_set", "size"));  // no_promise has the empty box
  EXPECT_THAT(certificate.violations[0].edges, ElementsAre(0, 1));
}

TEST_P(Violations, OrderAndDirectionOfEdgesAreFree) {
  Draft draft = star();
  const Graph graph = draft.graph();
  std::swap(draft.edges[0], draft.edges[3]);
  draft.edges[1].ends = {2, 0};
  EXPECT_THAT(kinds(judge(graph, draft, promise())), ElementsAre());
}

TEST_P(Violations, AnotherLattice) {
  Draft draft = star();
  draft.lattice = kScaledZLattice;
  EXPECT_THAT(kinds(judge(draft)), ElementsAre("lattice"));
}

TEST_P(Violations, AMultipleOfTheLatticeIsTheSameMetric) {
  Draft draft = star();
  draft.lattice = {{{{7, 0, 0}, {0, 7, 0}, {0, 0, 7}}}, 7};
  EXPECT_TRUE(judge(draft).valid());
}

TEST_P(Violations, CoordinateRange) {
  Draft draft = star();
  draft.edges[0].bends[0] = {kMaxCoordinate + 1, 4, 4};
  const Certificate certificate = judge(draft);
  EXPECT_THAT(kinds(certificate), ElementsAre("coordinate_range"));
  EXPECT_FALSE(certificate.complete);
}

TEST_P(Violations, Plane) {
  Draft draft = star();
  draft.vertices[1] = {7, 7, 1};  // one step short of the end of the same segment
  const Certificate certificate = judge(draft);
  EXPECT_THAT(kinds(certificate), ElementsAre("plane"));
  EXPECT_THAT(certificate.violations[0].vertices, ElementsAre(1));
}

TEST_P(Violations, DegenerateSegment) {
  Draft draft = star();
  draft.edges[2].bends.push_back({0, 0, 0});  // the end once more
  EXPECT_THAT(kinds(judge(draft)), ElementsAre("degenerate_segment"));
  draft.edges[2].bends = {{-4, 4, -4}, {-4, 4, -4}};
  EXPECT_THAT(kinds(judge(draft)), ElementsAre("degenerate_segment"));
}

TEST_P(Violations, Direction) {
  // Turned by the rational rotation (3, -4, 0; 4, 3, 0; 0, 0, 5) / 5 and scaled by 5: every angle
  // stays.
  const auto turned = [](Point p) { return Point{3 * p.x - 4 * p.y, 4 * p.x + 3 * p.y, 5 * p.z}; };
  Draft draft = star();
  for (Point& p : draft.vertices) p = turned(p);
  for (auto& edge : draft.edges) edge.bends[0] = turned(edge.bends[0]);
  Guarantee guarantee = promise();
  for (AxisBound& axis : guarantee.bound.axes) axis.constant = 1000;
  const Certificate certificate = judge(draft.graph(), draft, guarantee);
  EXPECT_THAT(kinds(certificate), ElementsAre("direction"));
  EXPECT_EQ(certificate.violations.size(), 8u);
}

TEST_P(Violations, Bends) {
  Draft draft = star();
  draft.edges[0].bends = {{2, 2, 2}, {4, 4, 0}, {5, 5, 1}, {7, 7, -1}};
  const Certificate certificate = judge(draft);
  EXPECT_THAT(kinds(certificate), ElementsAre("bends"));
  EXPECT_THAT(certificate.violations[0].edges, ElementsAre(0));
}

TEST_P(Violations, BendAngle) {
  Draft draft = star();
  draft.vertices[1] = {7, 1, 1};  // from (4, 4, 4) along (1, -1, -1), which is 70.5 degrees
  Guarantee guarantee = promise();
  guarantee.vertices_in_plane = false;
  const Certificate certificate = judge(draft.graph(), draft, guarantee);
  EXPECT_THAT(kinds(certificate), ElementsAre("bend_angle"));
  EXPECT_THAT(certificate.violations[0].points, ElementsAre(Point{4, 4, 4}));
}

TEST_P(Violations, VertexAngle) {
  Draft draft = star();
  draft.edges[0].bends[0] = {4, 4, -4};
  const Certificate certificate = judge(draft);
  EXPECT_THAT(kinds(certificate), ElementsAre("vertex_angle"));
  EXPECT_EQ(certificate.violations.size(), 3u);  // (1, 1, -1) against the three others
  EXPECT_THAT(certificate.violations[0].vertices, ElementsAre(0));
}

TEST_P(Violations, LargerAnglesMayBeAllowed) {
  Draft draft;
  draft.vertices = {{0, 0, 0}, {4, 4, 4}};
  draft.edges = {{{0, 1}, {{1, 1, 1}}}};  // a straight bend
  Guarantee guarantee = promise();
  guarantee.vertices_in_plane = false;
  EXPECT_THAT(kinds(judge(draft.graph(), draft, guarantee)), ElementsAre("bend_angle"));
  guarantee.angle_rule = AngleRule::at_least;
  EXPECT_THAT(kinds(judge(draft.graph(), draft, guarantee)), ElementsAre());
}

TEST_P(Violations, SamePoint) {
  Draft draft = star();
  draft.vertices[6] = draft.vertices[5];
  const Certificate certificate = judge(draft);
  EXPECT_THAT(kinds(certificate), ElementsAre("same_point"));
  EXPECT_THAT(certificate.violations[0].vertices, ElementsAre(5, 6));
  draft = star();
  draft.vertices[5] = draft.vertices[1];  // a vertex with an edge and one without
  EXPECT_THAT(kinds(judge(draft)), ElementsAre("same_point"));
}

TEST_P(Violations, VertexOnEdge) {
  Draft draft = star();
  draft.edges[0].bends = {{2, 2, 2}, {5, 5, -1}, {7, 7, 1}};
  EXPECT_THAT(kinds(judge(draft)), ElementsAre());
  draft.vertices[5] = {4, 4, 0};  // inside a segment
  const Certificate certificate = judge(draft);
  EXPECT_THAT(kinds(certificate), ElementsAre("vertex_on_edge"));
  ASSERT_EQ(certificate.violations.size(), 1u);
  EXPECT_THAT(certificate.violations[0].vertices, ElementsAre(5));
  EXPECT_THAT(certificate.violations[0].edges, ElementsAre(0));
  EXPECT_THAT(certificate.violations[0].points, ElementsAre(Point{4, 4, 0}));
}

TEST_P(Violations, VertexWithEdgesOnABend) {
  Draft draft = star();
  draft.vertices[5] = {4, 4, 4};  // the bend of edge 0
  draft.vertices[6] = {8, 4, 8};
  draft.edges.push_back({{5, 6}, {{6, 2, 6}, {7, 3, 7}}});
  Guarantee guarantee = no_promise();
  for (AxisBound& axis : guarantee.bound.axes) axis.constant = 1000;
  const Certificate certificate = judge(draft.graph(), draft, guarantee);
  EXPECT_THAT(kinds(certificate), ElementsAre("vertex_on_edge"));
  EXPECT_EQ(certificate.violations.size(), 1u);  // once, though two segments of edge 0 end there
}

TEST_P(Violations, Crossing) {
  Draft draft = star();
  draft.vertices[5] = {0, 4, 0};
  draft.vertices[6] = {6, -2, 0};
  draft.edges.push_back({{5, 6}, {{3, 1, 3}}});
  const Certificate certificate = judge(draft);
  EXPECT_THAT(kinds(certificate), ElementsAre("crossing"));
  ASSERT_EQ(certificate.violations.size(), 1u);
  EXPECT_THAT(certificate.violations[0].edges, ElementsAre(0, 4));
  EXPECT_THAT(certificate.violations[0].points, ElementsAre(Point{2, 2, 2}));
  EXPECT_THAT(certificate.violations[0].message, HasSubstr("they share (2, 2, 2)"));
}

TEST_P(Violations, Size) {
  Guarantee guarantee = promise();
  guarantee.bound.axes[0] = {20, 1, 0, 0};  // the drawing is 20 wide
  EXPECT_TRUE(judge(star().graph(), star(), guarantee).valid());
  guarantee.bound.axes[0] = {19, 1, 0, 0};
  EXPECT_THAT(kinds(judge(star().graph(), star(), guarantee)), ElementsAre("size"));
  CertifyOptions options;
  options.check_size = false;
  EXPECT_TRUE(certify(star().graph(), star().drawing(), guarantee, options).valid());
}

TEST_P(Violations, AreCountedUpToTheLimit) {
  // Six edges through one bend, twelve directions: each of the 15 pairs of edges has four pairs of
  // segments.
  Draft draft;
  for (Vertex i = 0; i < 12; ++i) draft.vertices.push_back({10 * i, 10, 70});
  for (Vertex i = 0; i < 12; i += 2) draft.edges.push_back({{i, i + 1}, {{0, 0, 0}}});
  CertifyOptions options;
  options.crossing_test = GetParam();
  options.check_size = false;
  for (const std::size_t limit : {std::size_t{0}, std::size_t{1}, std::size_t{59}, std::size_t{60},
                                  std::numeric_limits<std::size_t>::max()}) {
    options.max_violations = limit;
    const Certificate certificate = certify(draft.graph(), draft.drawing(), no_promise(), options);
    EXPECT_EQ(certificate.violations.size(), std::min<std::size_t>(limit, 60u));
    EXPECT_EQ(certificate.complete, limit >= 60u);
    EXPECT_FALSE(certificate.valid()) << limit;
  }
}

std::string_view name_of(CrossingTest test) {
  switch (test) {
    case CrossingTest::automatic:
      return "automatic";
    case CrossingTest::all_pairs:
      return "all_pairs";
    case CrossingTest::slabs:
      return "slabs";
  }
  return "unknown";
}

INSTANTIATE_TEST_SUITE_P(Tests, Violations,
                         ::testing::Values(CrossingTest::automatic, CrossingTest::all_pairs,
                                           CrossingTest::slabs),
                         [](const auto& info) { return std::string(name_of(info.param)); });

}  // namespace
}  // namespace ar3d::testing
