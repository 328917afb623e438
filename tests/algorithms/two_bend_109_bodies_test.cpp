// Lemma E.3: the stubs' angles. The finished bodies: certified with their rays, their slopes by
// exact cones, their sizes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "algorithms/two_bend_109_support.h"
#include "ar3d/algorithms/two_bend_109/drawn_segments.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/algorithms/two_bend_109/partition.h"
#include "ar3d/verify/predicates/exact.h"

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

/// Of what leans by one part in `slope`, in degrees.
double lean(std::int64_t slope) { return std::atan(1.0 / static_cast<double>(slope)) / kDegree; }

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

/// A row of the table of Lemma E.3, in tenths of a degree, rounded up; on a cycle, how far off its
/// two sides the stubs are, of which the table names the larger.
struct TableRow {
  Stance stance;
  unsigned downs;
  std::int64_t off_vertical;
  std::int64_t off_first;
  std::int64_t off_second;
  std::int64_t up_slope;
  std::int64_t down_slope;
};

std::int64_t tenths(double degrees) { return static_cast<std::int64_t>(std::ceil(10 * degrees)); }

TEST(TwoBend109Stubs, HaveTheAnglesOfTheTable) {
  const std::vector<TableRow> table = {
      {Stance::middle, 0, 590, 0, 0, 5, 5},
      {Stance::chain, 0, 563, 511, 195, 4, 4},
      {Stance::chain, 1, 429, 411, 320, 2, 2},
      {Stance::corner, 0, 563, 619, 571, 4, 4},
      {Stance::corner, 1, 429, 320, 116, 2, 2},
      {Stance::triangle_right, 0, 590, 636, 636, 5, 5},
      {Stance::triangle_right, 1, 429, 116, 493, 2, 2},
      {Stance::triangle_upper, 0, 590, 636, 636, 5, 5},
      {Stance::triangle_upper, 1, 429, 493, 116, 2, 2},
  };
  for (const TableRow& row : table) {
    SCOPED_TRACE(static_cast<int>(row.stance) * 10 + static_cast<int>(row.downs));
    const Stubs stubs = stubs_of(row.stance, row.downs);
    EXPECT_EQ(tenths(std::max(angle(real(stubs.ends[0]), kUp),
                              angle(real(stubs.ends[1]), row.downs == 1 ? kDown : kUp))),
              row.off_vertical);
    EXPECT_EQ(stubs.up_slope, row.up_slope);
    EXPECT_EQ(stubs.down_slope, row.down_slope);
    if (row.stance == Stance::middle) continue;
    const auto sides = std::find_if(kCycleStances.begin(), kCycleStances.end(),
                                    [&](const Sides& known) { return known.stance == row.stance; });
    EXPECT_EQ(tenths(angle(real(stubs.ends[2]), sides->first)), row.off_first);
    EXPECT_EQ(tenths(angle(real(stubs.ends[3]), sides->second)), row.off_second);
  }
  const Stubs three = stubs_of(Stance::three_down, 3);
  EXPECT_EQ(three.ends[0], (Vector{0, 0, 3}));
  for (const std::size_t i : {1u, 2u, 3u}) {
    EXPECT_NEAR(angle(real(three.ends[i]), kDown), kMostTurn, 1e-12);
  }
  EXPECT_EQ(three.up_slope, 1);
  EXPECT_EQ(three.down_slope, 3);
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

/// The body as a drawing, with a vertex at the end of a ray from each leg far below.
Drawing with_rays(const SmallBody& body, Graph& graph) {
  std::vector<Edge> edges;
  std::vector<Point> at = body.vertices;
  std::vector<std::vector<Point>> bends;
  for (const SmallBody::BodyLink& link : body.links) {
    edges.push_back({link.u, link.v});
    bends.push_back({link.bend_at_u, link.bend_at_v});
  }
  for (const auto& [v, end] : body.legs) {
    edges.push_back({v, static_cast<Vertex>(at.size())});
    at.push_back({end.x, end.y, -1000000});
    bends.push_back({end});
  }
  graph = Graph(at.size(), edges);
  return testing::two_bend_drawing(edges, at, bends);
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

__extension__ using Int128 = __int128;

/// Whether some endless ray down from `apex` that leans by at most one part in `slope` meets the
/// segment from a to b, in exact integers. With w(t) = a - apex + t (b - a) such a ray does iff
/// w_z <= 0 and f = w_z^2 - slope^2 (2 w_x^2 + 6 w_y^2) >= 0 for some t in [0, 1], that is, at an
/// end or at the largest value of f, or at the apex itself. Coordinates below 2^18 and slopes below
/// 2^9 keep the coefficients of f below 2^60 and their products below 2^122.
bool some_ray_meets(Point apex, Point a, Point b, std::int64_t slope) {
  if (verify::on_segment(apex, a, b)) return true;
  const Vector w = a - apex;
  const Vector d = b - a;
  const auto form = [&](Vector p, Vector q) {
    return Int128{p.z} * q.z - Int128{slope} * slope * (2 * p.x * q.x + 6 * p.y * q.y);
  };
  const Int128 square = form(d, d), linear = 2 * form(w, d), constant = form(w, w);
  if (w.z <= 0 && constant >= 0) return true;
  if (w.z + d.z <= 0 && square + linear + constant >= 0) return true;
  if (square >= 0 || linear <= 0 || linear >= -2 * square) return false;
  const Int128 height = -2 * square * w.z + linear * d.z;  // at the largest f, times -2 square
  return height <= 0 && 4 * square * constant <= linear * linear;
}

/// Whether some such ray from a leg's end meets the body; not its own leg, which it leaves at an
/// angle.
bool some_ray_meets(const SmallBody& body, Vertex v, Point end, std::int64_t slope) {
  for (const SmallBody::BodyLink& link : body.links) {
    const std::array<Point, 4> line = {body.vertices[link.u], link.bend_at_u, link.bend_at_v,
                                       body.vertices[link.v]};
    for (std::size_t i = 0; i < 3; ++i) {
      if (some_ray_meets(end, line[i], line[i + 1], slope)) return true;
    }
  }
  return std::ranges::any_of(body.legs, [&](const auto& other) {
    return other.first != v && some_ray_meets(end, body.vertices[other.first], other.second, slope);
  });
}

// What Lemma E.5 needs of the bodies, in exact integers except for a leg's angle, which has 0.2
// degrees to spare.
TEST(TwoBend109Bodies, RaysMayLeanAsTheirSlopeSays) {
  std::set<std::string> need_more_than_5;
  for (const SmallBody& body : small_bodies()) {
    for (const auto& [v, end] : body.legs) {
      const Vector stub = end - body.vertices[v];
      EXPECT_LE(angle(real(stub), kDown), 58.8) << body.name;
      EXPECT_GE(body.slope, 5) << body.name;
      EXPECT_FALSE(some_ray_meets(body, v, end, body.slope)) << body.name << " leg of " << v;
      if (some_ray_meets(body, v, end, 5)) need_more_than_5.insert(body.name);
    }
  }
  EXPECT_LT(58.8 + lean(5), kMostTurn - 0.2);
  EXPECT_THAT(need_more_than_5, ::testing::ElementsAre("K3,3", "K3,3 + e", "K4"));
}

TEST(TwoBend109Bodies, RaysMeetWhatLiesInTheirCone) {
  const Point apex{3, -2, 7};
  const auto below = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    return Point{apex.x + x, apex.y + y, apex.z - z};
  };
  // (1, 1, 20) is 2 sqrt 2 off the vertical line: one part in 7.07.
  EXPECT_TRUE(some_ray_meets(apex, below(1, 1, 20), below(50, 50, 20), 7));
  EXPECT_FALSE(some_ray_meets(apex, below(1, 1, 20), below(50, 50, 20), 8));
  EXPECT_TRUE(some_ray_meets(apex, below(50, 50, 20), below(1, 1, 20), 7)) << "at the other end";
  // Only its inner points are below the apex: through the vertical line, beside it, above it.
  EXPECT_TRUE(some_ray_meets(apex, below(-50, 0, 20), below(50, 0, 20), 100));
  EXPECT_TRUE(some_ray_meets(apex, below(-50, 1, 20), below(50, 1, 20), 8));  // 20 / sqrt 6 = 8.16
  EXPECT_FALSE(some_ray_meets(apex, below(-50, 1, 20), below(50, 1, 20), 9));
  EXPECT_FALSE(some_ray_meets(apex, below(-50, 0, -20), below(50, 0, -20), 5));
  EXPECT_FALSE(some_ray_meets(apex, below(-50, 0, -900), below(50, 0, -1), 5));
  EXPECT_TRUE(some_ray_meets(apex, below(-1, 0, -1), below(1, 0, 1), 5)) << "through the apex";
}

// The constants of Lemma E.6.
TEST(TwoBend109Bodies, ReachNoFurtherThanLemmaE6Says) {
  Point high;
  std::int64_t slope = 0;
  for (const SmallBody& body : small_bodies()) {
    const auto add = [&](Point p) {
      EXPECT_TRUE(p.x >= 0 && p.y >= 0 && p.z >= 0) << body.name;
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    };
    for (const Point& p : body.vertices) add(p);
    for (const SmallBody::BodyLink& link : body.links) {
      add(link.bend_at_u);
      add(link.bend_at_v);
    }
    for (const auto& [v, end] : body.legs) add(end);
    slope = std::max(slope, body.slope);
    EXPECT_LE(body.legs.size(), 6u) << "edges, and 15 pairs of them (Lemma E.5)";
  }
  EXPECT_EQ(high.x, 40825);
  EXPECT_EQ(high.y, 36628);
  EXPECT_EQ(high.z + kStep, 81744);
  EXPECT_EQ(slope, 280);
  // Step E.3: with the neighbours' span X in x an edge to a body has |dx| <= (X + 40825)/2 + 40 and
  // |dy| <= 36628 + r + 22 and B <= 2 J + 16 more of each.
  for (double j = 42; j < 1e9; j *= 1.3) {
    for (const double n : {4.0, 5.0, 10.0, 1e3, 1e6}) {
      const double dx = (n * (20 * j + 925) + 40825) / 2 + 40 + 2 * j + 16;
      const double dy = 36628 + (6 * j + 280) + 22 + 2 * j + 16;
      const double lift = 280 * ((3 * dx + 5 * dy) / 2 + 1) + 2 * 21;
      EXPECT_LE(lift, 8400 * n * j + 388500 * n + 5600 * j + 4.3e7) << n << " " << j;
    }
  }
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
    for (const auto& [u, u_end] : body.legs) {
      for (const auto& [v, v_end] : body.legs) {
        if (u == v) continue;
        EXPECT_NE(u_end.z, v_end.z) << body.name;
        for (const Vector& d : differences)
          EXPECT_FALSE(are_parallel(d, u_end - v_end)) << body.name;
      }
    }
  }
}

}  // namespace
}  // namespace ar3d::two_bend_109
