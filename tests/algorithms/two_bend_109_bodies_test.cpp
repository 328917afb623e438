// The finished bodies: certified with their rays, their slopes by exact cones, their sizes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>

#include "algorithms/two_bend_109_angles.h"
#include "algorithms/two_bend_109_support.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/algorithms/two_bend_109/small_bodies.h"
#include "ar3d/verify/predicates/exact.h"

namespace ar3d::two_bend_109 {
namespace {

/// The body as a drawing, with a vertex at the end of a ray from each leg far below.
Drawing with_rays(const SmallBody& body, Graph& graph) {
  std::vector<Edge> edges;
  std::vector<Point> at = body.vertices;
  std::vector<std::vector<Point>> bends;
  std::int64_t largest = 1;
  for (const SmallBody::BodyLink& link : body.links) {
    edges.push_back({link.u, link.v});
    bends.push_back({link.bend_at_u, link.bend_at_v});
  }
  for (const SmallBody::BodyLeg& leg : body.legs) {
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
bool some_ray_meets(const SmallBody& body, const SmallBody::BodyLeg& leg, std::int64_t slope) {
  for (const SmallBody::BodyLink& link : body.links) {
    const std::array<Point, 4> line = {body.vertices[link.u], link.bend_at_u, link.bend_at_v,
                                       body.vertices[link.v]};
    for (std::size_t i = 0; i < 3; ++i) {
      if (some_ray_meets(leg.end, line[i], line[i + 1], slope)) return true;
    }
  }
  return std::any_of(body.legs.begin(), body.legs.end(), [&](const SmallBody::BodyLeg& other) {
    return other.v != leg.v && some_ray_meets(leg.end, body.vertices[other.v], other.end, slope);
  });
}

// What Lemma E.5 needs of the bodies, in exact integers but for the angle of a leg, which has 0.2
// degrees to spare.
TEST(TwoBend109Bodies, RaysMayLeanAsTheirSlopeSays) {
  std::set<std::string> need_more_than_5;
  for (const SmallBody& body : small_bodies()) {
    for (const SmallBody::BodyLeg& leg : body.legs) {
      const Vector stub = leg.end - body.vertices[leg.v];
      EXPECT_LE(angle(real(stub), kDown), 58.8) << body.name;
      EXPECT_GE(body.slope, 5) << body.name;
      EXPECT_FALSE(some_ray_meets(body, leg, body.slope)) << body.name << " leg of " << leg.v;
      if (some_ray_meets(body, leg, 5)) need_more_than_5.insert(body.name);
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
    for (const SmallBody::BodyLeg& leg : body.legs) add(leg.end);
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
    for (const SmallBody::BodyLeg& a : body.legs) {
      for (const SmallBody::BodyLeg& b : body.legs) {
        if (a.v == b.v) continue;
        EXPECT_NE(a.end.z, b.end.z) << body.name;
        for (const Vector& d : differences) EXPECT_FALSE(parallel(d, a.end - b.end)) << body.name;
      }
    }
  }
}

}  // namespace
}  // namespace ar3d::two_bend_109
