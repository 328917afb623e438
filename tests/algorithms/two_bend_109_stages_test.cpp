// Lemma E.3, Step E.2, the finished bodies, the comparison of two segments.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "algorithms/two_bend_109_support.h"
#include "ar3d/algorithms/two_bend_109/crossings.h"
#include "ar3d/algorithms/two_bend_109/slots.h"
#include "ar3d/model/error.h"
#include "ar3d/model/random.h"
#include "ar3d/verify/exact.h"
#include "support/graphs.h"

namespace ar3d::two_bend_109 {
namespace {

using Real3 = std::array<double, 3>;

double dot(Real3 a, Real3 b) { return 2 * a[0] * b[0] + 6 * a[1] * b[1] + a[2] * b[2]; }
Real3 real(Vector d) {
  return {static_cast<double>(d.x), static_cast<double>(d.y), static_cast<double>(d.z)};
}
Vector minus(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr double kDegree = std::numbers::pi / 180;
double angle(Real3 a, Real3 b) {
  return std::acos(dot(a, b) / std::sqrt(dot(a, a) * dot(b, b))) / kDegree;
}
/// The horizontal direction at this angle from the x-axis.
Real3 at(double degrees) {
  return {std::cos(degrees * kDegree) / std::sqrt(2.0),
          std::sin(degrees * kDegree) / std::sqrt(6.0), 0};
}
constexpr Real3 kUp = {0, 0, 1};
constexpr Real3 kDown = {0, 0, -1};
const double kMostTurn = std::acos(1.0 / 3) / kDegree;

struct Sides {
  Stance stance;
  Real3 first;
  Real3 second;
  double slack;  ///< what Lemma E.4 needs, in degrees
};
const std::vector<Sides> kCycleStances = {{Stance::chain, at(0), at(180), 6.7},
                                          {Stance::corner, at(0), at(90), 6.7},
                                          {Stance::triangle_right, at(150), at(210), 6.8},
                                          {Stance::triangle_upper, at(-30), at(-90), 6.8}};

std::vector<Stubs> all_stubs() {
  std::vector<Stubs> all = {stubs_of(Stance::middle, 0), stubs_of(Stance::three_down, 3)};
  for (const Sides& sides : kCycleStances) {
    for (const unsigned downs : {0u, 1u, 2u}) all.push_back(stubs_of(sides.stance, downs));
  }
  return all;
}

TEST(TwoBend109Stubs, AreRegularTetrahedraOfTheStatedSize) {
  for (const Stubs& stubs : all_stubs()) {
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LE(std::abs(stubs.ends[i].x), kStubX);
      EXPECT_LE(std::abs(stubs.ends[i].y), kStubY);
      EXPECT_LE(std::abs(stubs.ends[i].z), kStubZ);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_TRUE(compare_cosine(kAxisLattice, stubs.ends[i], stubs.ends[j], {-1, 3}) == 0);
      }
    }
  }
  for (const Stance stance : {Stance::chain, Stance::corner}) {
    for (const unsigned downs : {0u, 1u, 2u}) {
      for (const Vector& end : stubs_of(stance, downs).ends) {
        EXPECT_LE(std::abs(end.z), kCycleStubZ);
      }
    }
  }
}

void expect_slack(Vector stub, Real3 direction, double needed) {
  EXPECT_LE(angle(real(stub), direction) + needed, kMostTurn) << to_string(stub);
}
double lean(std::int64_t slope) { return std::atan(1.0 / static_cast<double>(slope)) / kDegree; }

TEST(TwoBend109Stubs, LeaveTheSlackThatLemmaE4Needs) {
  const Stubs middle = stubs_of(Stance::middle, 0);
  for (const std::size_t i : {0u, 1u}) expect_slack(middle.ends[i], kUp, lean(middle.up_slope));
  for (const std::size_t i : {2u, 3u}) expect_slack(middle.ends[i], kDown, lean(middle.down_slope));
  const Stubs three = stubs_of(Stance::three_down, 3);
  expect_slack(three.ends[0], kUp, lean(three.up_slope));
  for (const Sides& sides : kCycleStances) {
    for (const unsigned downs : {0u, 1u, 2u}) {
      const Stubs stubs = stubs_of(sides.stance, downs);
      for (const std::size_t i : {0u, 1u}) {
        const bool goes_up = downs == 0 || (downs == 1 && i == 0);
        expect_slack(stubs.ends[i], goes_up ? kUp : kDown,
                     lean(goes_up ? stubs.up_slope : stubs.down_slope));
      }
      expect_slack(stubs.ends[2], sides.first, sides.slack);
      expect_slack(stubs.ends[3], sides.second, sides.slack);
    }
  }
}

// The condition of docs/two-bend-109.md on the lower stubs of three down, against the angle itself.
TEST(TwoBend109Stubs, OfThreeDownTakeEdgesOnTheirSide) {
  const Stubs three = stubs_of(Stance::three_down, 3);
  const std::array<double, 3> seen = {0, 120, 240};
  for (std::size_t i = 0; i < 3; ++i) {
    for (double t = 0.5; t <= lean(three.down_slope); t += 0.5) {
      for (double p = -86.7; p <= 86.7; p += 0.3) {
        Real3 ahead = at(seen[i] + p);
        for (double& c : ahead) c *= std::tan(t * kDegree);
        ahead[2] = -1;
        EXPECT_LE(angle(real(three.ends[1 + i]), ahead), kMostTurn) << t << " " << p;
      }
    }
  }
}

// Lemma E.5: no two new middles are the diagonals of a trapezium.
TEST(TwoBend109Stubs, DiagonalsAreExcludedByHeightsAndSides) {
  const Stubs middle = stubs_of(Stance::middle, 0);
  EXPECT_EQ(middle.ends[2].z, middle.ends[3].z) << "a horizontal difference";
  const Stubs three = stubs_of(Stance::three_down, 3);
  EXPECT_EQ(three.ends[2].z, three.ends[3].z);
  EXPECT_GT(three.ends[2].y, three.ends[3].y) << "and inside a triangle the upper corner's";
  for (const std::size_t i : {2u, 3u}) {
    EXPECT_GT(three.ends[1].x, three.ends[i].x) << "the lone one is on the right";
  }
  for (const Sides& sides : kCycleStances) {
    const Stubs down = stubs_of(sides.stance, 2);
    EXPECT_LE(down.ends[0].z, down.ends[1].z) << "the first leads to the lower vertex";
    for (const unsigned downs : {1u, 2u}) {
      const Stubs stubs = stubs_of(sides.stance, downs);
      for (const std::size_t i : {2u, 3u}) {
        EXPECT_GT(stubs.ends[i].z, stubs.ends[1].z);
        EXPECT_TRUE(downs == 1 || stubs.ends[i].z > stubs.ends[0].z);
      }
    }
    for (const unsigned downs : {0u, 1u, 2u}) {
      const Stubs stubs = stubs_of(sides.stance, downs);
      const Vector d = minus(stubs.ends[2], stubs.ends[3]);
      // The neighbour of the first side has larger x, or at the triangle's right corner larger y.
      if (sides.stance == Stance::triangle_right) {
        EXPECT_GT(d.y, 0);
      } else {
        EXPECT_GT(d.x, 0);
      }
    }
  }
}

TEST(TwoBend109Slots, ListKeepsItsOrder) {
  SlotList list;
  std::vector<std::uint32_t> expected;
  RandomStream random(1);
  for (int i = 0; i < 3000; ++i) {
    // Half of them at one place, so that the labels between two slots run out.
    const std::size_t place = expected.empty() ? 0
                              : i % 2 == 0
                                  ? expected.size() / 2
                                  : random.below(static_cast<std::uint32_t>(expected.size() + 1));
    const std::uint32_t slot =
        list.insert_after(place == 0 ? SlotList::kNone : expected[place - 1]);
    expected.insert(expected.begin() + static_cast<std::ptrdiff_t>(place), slot);
  }
  EXPECT_EQ(list.in_order(), expected);
  for (std::size_t i = 1; i < expected.size(); ++i) {
    EXPECT_TRUE(list.is_before(expected[i - 1], expected[i]));
  }
}

TEST(TwoBend109Slots, SomeSinglesStandInsideTriangles) {
  std::map<Spot, int> seen;
  for (const Graph& graph : testing::geng("-c -D4 7")) {
    for (const Spot spot : arrange(graph, find_partition(graph)).spot) ++seen[spot];
  }
  EXPECT_GT(seen[Spot::centre], 0);
  EXPECT_GT(seen[Spot::left_inside], 0);
}

/// The body as a drawing, with a vertex at the end of a ray from each leg far below.
Drawing with_rays(const SmallBody& body, Graph& graph) {
  std::vector<Edge> edges;
  std::vector<Point> at = body.vertices;
  std::vector<std::vector<Point>> bends;
  std::int64_t largest = 1;
  for (const SmallBody::Link& link : body.links) {
    edges.push_back({link.u, link.v});
    bends.push_back({link.bend_at_u, link.bend_at_v});
  }
  for (const SmallBody::Leg& leg : body.legs) {
    edges.push_back({leg.v, static_cast<Vertex>(at.size())});
    at.push_back({leg.end.x, leg.end.y, -1000000});
    bends.push_back({leg.end});
  }
  for (const Point& p : at)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  Coordinates vertices(at.size(), largest);
  for (std::size_t i = 0; i < at.size(); ++i) vertices.set(i, at[i]);
  auto stored = std::make_shared<StoredBends>();
  for (const auto& points : bends) stored->add_edge(points);
  graph = Graph(at.size(), edges);
  return {"two-bend-109", kAxisLattice, std::move(vertices),
          std::make_shared<const std::vector<Edge>>(std::move(edges)), std::move(stored)};
}

// The rays end below the body, which reaches no further down: endless ones meet no more.
TEST(TwoBend109Bodies, AreCertifiedWithTheirRays) {
  Guarantee guarantee = row().guarantee;
  for (const SmallBody& body : small_bodies()) {
    Graph graph;
    const Drawing drawing = with_rays(body, graph);
    const Certificate certificate = certify(
        graph, drawing, guarantee, {.crossing_test = CrossingTest::all_pairs, .check_size = false});
    ASSERT_TRUE(certificate.valid()) << body.name << ": " << certificate.violations[0].message;
    for (std::size_t v = 0; v < body.vertices.size(); ++v) {
      EXPECT_GE(graph.degree(static_cast<Vertex>(v)), body.name == "K5" ? 4u : 3u);
    }
  }
}

/// How little a ray from `apex` may lean to meet the segment from a to b at the earliest: the
/// largest s such that the cone of rays that lean by one part in s reaches it.
double reached_by(Point apex, Point a, Point b) {
  const Real3 p = real(a - apex);
  const Real3 d = real(b - a);
  double largest = 0;
  // The lean along the segment has at most one extremum below the apex: sampled finely, with the
  // ends.
  constexpr int kSamples = 20000;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = static_cast<double>(i) / kSamples;
    const Real3 q = {p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]};
    if (q[2] < 0) largest = std::max(largest, -q[2] / std::sqrt(2 * q[0] * q[0] + 6 * q[1] * q[1]));
  }
  return largest;
}

TEST(TwoBend109Bodies, RaysMayLeanAsTheirSlopeSays) {
  for (const SmallBody& body : small_bodies()) {
    for (const SmallBody::Leg& leg : body.legs) {
      const Vector stub = leg.end - body.vertices[leg.v];
      EXPECT_LE(angle(real(stub), kDown) + lean(5), kMostTurn - 0.2) << body.name;
      EXPECT_GE(body.slope, 5) << body.name;
      double needed = 0;
      for (const SmallBody::Link& link : body.links) {
        const std::array<Point, 4> line = {body.vertices[link.u], link.bend_at_u, link.bend_at_v,
                                           body.vertices[link.v]};
        for (std::size_t i = 0; i < 3; ++i) {
          needed = std::max(needed, reached_by(leg.end, line[i], line[i + 1]));
        }
      }
      for (const SmallBody::Leg& other : body.legs) {
        if (other.v != leg.v) {
          needed = std::max(needed, reached_by(leg.end, body.vertices[other.v], other.end));
        }
      }
      EXPECT_LE(needed * 1.005, static_cast<double>(body.slope)) << body.name;
    }
  }
}

bool parallel(Vector u, Vector v) {
  return u.y * v.z == u.z * v.y && u.z * v.x == u.x * v.z && u.x * v.y == u.y * v.x;
}

TEST(TwoBend109Bodies, TwoStubsUpNeverDifferAlongTwoLegs) {
  std::vector<Vector> differences;
  for (const Stubs& stubs : all_stubs()) {
    for (const bool in_x : {false, true}) {
      for (const bool in_y : {false, true}) {
        const Stubs seen = mirrored(stubs, in_x, in_y);
        differences.push_back(minus(seen.ends[0], seen.ends[1]));
      }
    }
  }
  for (const SmallBody& body : small_bodies()) {
    for (const SmallBody::Leg& a : body.legs) {
      for (const SmallBody::Leg& b : body.legs) {
        if (a.v == b.v) continue;
        EXPECT_NE(a.end.z, b.end.z) << body.name;
        for (const Vector& d : differences) EXPECT_FALSE(parallel(d, a.end - b.end)) << body.name;
      }
    }
  }
}

TEST(TwoBend109Crossings, TwoSegmentsMeetIffTheVerifierSaysSo) {
  RandomStream random(5);
  const auto point = [&](std::uint32_t size) {
    return Point{random.below(size), random.below(size), random.below(size)};
  };
  int met = 0;
  for (int i = 0; i < 40000; ++i) {
    const std::uint32_t size = 2 + static_cast<std::uint32_t>(i % 5);
    const Segment a{point(size), point(size)};
    const Segment b{point(size), point(size)};
    if (a.from == a.to || b.from == b.to) continue;
    const bool said = meet(a, b);
    const verify::Meeting meeting = verify::meet(a.from, a.to, b.from, b.to);
    EXPECT_EQ(said, meeting.kind != verify::Meeting::Kind::nothing);
    EXPECT_EQ(said, meet(b, a));
    EXPECT_EQ(said, meet({a.to, a.from}, b));
    met += said ? 1 : 0;
  }
  EXPECT_GT(met, 1000);
}

TEST(TwoBend109Crossings, LargeCoordinatesAreExact) {
  const std::int64_t far = std::int64_t{1} << 60;
  // Two lines that cross in one lattice point, and the same with one end moved by one.
  const Segment a{{-far, 0, -far}, {far, 2, far}};
  const Segment b{{far, 0, -far}, {-far, 2, far}};
  EXPECT_TRUE(meet(a, b));
  EXPECT_FALSE(meet(a, {{far, 0, -far}, {-far, 3, far}}));
  EXPECT_FALSE(meet({{-far, 0, -far}, {far, 2, far - 1}}, {{far, 0, -far}, {-far, 2, far - 2}}));
}

}  // namespace
}  // namespace ar3d::two_bend_109
