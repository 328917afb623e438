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
    return certify(graph, draft.drawing(), guarantee, {.crossing_test = GetParam()});
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

Draft moved(Vertex v, Point to, Draft draft = star()) {
  draft.vertices[v] = to;
  return draft;
}
Draft bent(EdgeId e, std::vector<Point> bends, Draft draft = star()) {
  draft.edges[e].bends = std::move(bends);
  return draft;
}
Draft joined(Vertex u, Vertex v, std::vector<Point> bends, Draft draft) {
  draft.edges.push_back({{u, v}, std::move(bends)});
  return draft;
}

/// A changed star, and what is then named.
struct Change {
  std::string kind;  ///< of all violations; empty: there are none
  Draft draft;
  std::vector<Vertex> vertices{};  ///< of the first violation, as edges, points and a part of the
  std::vector<EdgeId> edges{};     ///< message; where nothing is said, nothing is checked
  std::vector<Point> points{};
  std::string message{};
  std::size_t count = 1;  ///< of violations
};

std::vector<Change> changes() {
  const Draft low = bent(0, {{2, 2, 2}, {5, 5, -1}, {7, 7, 1}});
  return {{"", low},
          {"coordinate_range", bent(0, {{kMaxCoordinate + 1, 4, 4}})},
          {"plane", moved(1, {7, 7, 1}), {1}},  // one step short of the end of the same segment
          {"degenerate_segment", bent(2, {{-4, 4, -4}, {0, 0, 0}})},  // the end once more
          {"degenerate_segment", bent(2, {{-4, 4, -4}, {-4, 4, -4}})},
          {"bends", bent(0, {{2, 2, 2}, {4, 4, 0}, {5, 5, 1}, {7, 7, -1}}), {}, {0}},
          // (1, 1, -1) against the three others.
          {"vertex_angle", bent(0, {{4, 4, -4}}), {0}, {}, {}, "", 3},
          {"same_point", moved(6, {10, 0, 0}), {5, 6}},
          {"same_point", moved(5, {8, 8, 0})},  // a vertex with an edge and one without
          {"vertex_on_edge", moved(5, {4, 4, 0}, low), {5}, {0}, {{4, 4, 0}}},  // in a segment
          {"crossing",
           joined(5, 6, {{3, 1, 3}}, moved(5, {0, 4, 0}, moved(6, {6, -2, 0}))),
           {},
           {0, 4},
           {{2, 2, 2}},
           "they share (2, 2, 2)"}};
}

TEST_P(Violations, AreNamedOnceInAChangedStar) {
  for (const Change& row : changes()) {
    SCOPED_TRACE(row.kind);
    const Certificate certificate = judge(row.draft);
    EXPECT_EQ(certificate.complete, row.kind != "coordinate_range");
    EXPECT_EQ(certificate.valid(), row.kind.empty());
    if (row.kind.empty()) continue;
    EXPECT_THAT(kinds(certificate), ElementsAre(row.kind));
    ASSERT_EQ(certificate.violations.size(), row.count);
    const Violation& first = certificate.violations[0];
    EXPECT_TRUE(row.vertices.empty() || first.vertices == row.vertices);
    EXPECT_TRUE(row.edges.empty() || first.edges == row.edges);
    EXPECT_TRUE(row.points.empty() || first.points == row.points);
    EXPECT_THAT(first.message, HasSubstr(row.message));
  }
}

TEST_P(Violations, OfAnotherGraph) {
  Draft draft = star();
  draft.vertices.push_back({0, 5, 0});
  EXPECT_THAT(kinds(judge(star().graph(), draft, promise())), ElementsAre("vertex_count"));
  draft = star();
  draft.edges.erase(draft.edges.begin() + 2);
  const std::vector<Violation> missing = judge(star().graph(), draft, promise()).violations;
  const std::vector<Violation> extra = judge(draft.graph(), star(), promise()).violations;
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_STREQ(to_string(missing[0].kind), "edge_set");
  EXPECT_THAT(missing[0].vertices, ElementsAre(0, 3));
  EXPECT_EQ(missing[0].message, "the graph's edge 2 (0-3) is not drawn");
  ASSERT_EQ(extra.size(), 1u);
  EXPECT_STREQ(to_string(extra[0].kind), "edge_set");
  EXPECT_THAT(extra[0].edges, ElementsAre(2));
}

TEST_P(Violations, OfTheLatticeAreNoMultiplesOfIt) {
  Draft draft = star();
  draft.lattice = kScaledZLattice;
  EXPECT_THAT(kinds(judge(draft)), ElementsAre("lattice"));
  draft.lattice = {{{{7, 0, 0}, {0, 7, 0}, {0, 0, 7}}}, 7};
  EXPECT_TRUE(judge(draft).valid());
}

TEST_P(Violations, OrderAndDirectionOfEdgesAreFree) {
  Draft draft = star();
  std::swap(draft.edges[0], draft.edges[3]);
  draft.edges[1].ends = {2, 0};
  EXPECT_TRUE(judge(star().graph(), draft, promise()).valid());
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

TEST_P(Violations, BendAngle) {
  Draft draft = star();
  draft.vertices[1] = {7, 1, 1};  // from (4, 4, 4) along (1, -1, -1), which is 70.5 degrees
  Guarantee guarantee = promise();
  guarantee.vertices_in_plane = false;
  const Certificate certificate = judge(draft.graph(), draft, guarantee);
  EXPECT_THAT(kinds(certificate), ElementsAre("bend_angle"));
  EXPECT_THAT(certificate.violations[0].points, ElementsAre(Point{4, 4, 4}));
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

TEST_P(Violations, Size) {
  Guarantee guarantee = promise();
  guarantee.bound.axes[0] = {20, 1, 0, 0};  // the drawing is 20 wide
  EXPECT_TRUE(judge(star().graph(), star(), guarantee).valid());
  guarantee.bound.axes[0] = {19, 1, 0, 0};
  EXPECT_THAT(kinds(judge(star().graph(), star(), guarantee)), ElementsAre("size"));
  EXPECT_TRUE(certify(star().graph(), star().drawing(), guarantee, {.check_size = false}).valid());
}

TEST_P(Violations, AreCountedUpToTheLimit) {
  // Six edges through one bend, twelve directions: each of the 15 pairs of edges has four pairs of
  // segments.
  Draft draft;
  for (Vertex i = 0; i < 12; ++i) draft.vertices.push_back({10 * i, 10, 70});
  for (Vertex i = 0; i < 12; i += 2) draft.edges.push_back({{i, i + 1}, {{0, 0, 0}}});
  CertifyOptions options{.crossing_test = GetParam(), .check_size = false};
  for (const std::size_t limit : {std::size_t{0}, std::size_t{1}, std::size_t{59}, std::size_t{60},
                                  std::numeric_limits<std::size_t>::max()}) {
    options.max_violations = limit;
    const Certificate certificate = certify(draft.graph(), draft.drawing(), no_promise(), options);
    EXPECT_EQ(certificate.violations.size(), std::min<std::size_t>(limit, 60u));
    EXPECT_EQ(certificate.complete, limit >= 60u);
    EXPECT_FALSE(certificate.valid()) << limit;
  }
}

constexpr const char* kCrossingTests[] = {"automatic", "all_pairs", "halving"};

INSTANTIATE_TEST_SUITE_P(Tests, Violations,
                         ::testing::Values(CrossingTest::automatic, CrossingTest::all_pairs,
                                           CrossingTest::halving),
                         [](const auto& info) {
                           return kCrossingTests[static_cast<std::size_t>(info.param)];
                         });

}  // namespace
}  // namespace ar3d::testing
