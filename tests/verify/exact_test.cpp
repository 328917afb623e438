#include "ar3d/verify/predicates/exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "ar3d/base/random.h"

namespace ar3d::verify {
namespace {

using Real = std::array<double, 3>;

Real real(Vector v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
double dot(const Real& a, const Real& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double unit(double t) { return std::clamp(t, 0.0, 1.0); }

/// Squared distance from a + s u to the nearest point of c + [0, 1] v, given w = c - a.
double distance_at(double s, const Real& u, const Real& v, const Real& w) {
  const Real from_c{s * u[0] - w[0], s * u[1] - w[1], s * u[2] - w[2]};
  const double t = unit(dot(from_c, v) / dot(v, v));
  const Real gap{from_c[0] - t * v[0], from_c[1] - t * v[1], from_c[2] - t * v[2]};
  return dot(gap, gap);
}

/// The distance of two segments is a convex function of the place on the first: ternary search
/// finds its minimum.
double squared_distance(Point a, Point b, Point c, Point d) {
  const Real u = real(b - a);
  const Real v = real(d - c);
  const Real w = real(c - a);
  double low = 0;
  double high = 1;
  for (int i = 0; i < 100; ++i) {
    const double left = low + (high - low) / 3;
    const double right = high - (high - low) / 3;
    (distance_at(left, u, v, w) < distance_at(right, u, v, w) ? high : low) =
        distance_at(left, u, v, w) < distance_at(right, u, v, w) ? right : left;
  }
  return distance_at(low, u, v, w);
}

Point random_point(RandomStream& random, std::uint32_t side) {
  return {random.below(side), random.below(side), random.below(side)};
}

// With coordinates below 5, segments that do not meet are at least 1/|n| > 0.01 or 1/|v| apart.
TEST(Meet, AgreesWithFloatingDistancesOfSmallSegments) {
  RandomStream random(1);
  std::size_t meetings = 0;
  for (int i = 0; i < 60000; ++i) {
    const Point a = random_point(random, 5);
    const Point b = random_point(random, 5);
    const Point c = random_point(random, 5);
    const Point d = random_point(random, 5);
    if (a == b || c == d) continue;
    const bool meets = meet(a, b, c, d).kind != MeetingKind::nothing;
    meetings += meets;
    ASSERT_EQ(meets, squared_distance(a, b, c, d) < 1e-5)
        << to_string(a) << to_string(b) << to_string(c) << to_string(d);
  }
  EXPECT_GT(meetings, 1000u);
}

TEST(Meet, NamesTheLatticePointOrTheCommonPart) {
  const Meeting at = meet({0, 0, 0}, {4, 4, 4}, {1, 3, 2}, {3, 1, 2});
  EXPECT_EQ(at.kind, MeetingKind::cross);
  EXPECT_EQ(at.at, (Point{2, 2, 2}));
  const Meeting between = meet({0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0});
  EXPECT_EQ(between.kind, MeetingKind::cross);
  EXPECT_FALSE(between.at.has_value());
  const Meeting part = meet({0, 0, 0}, {6, 6, 6}, {9, 9, 9}, {4, 4, 4});
  EXPECT_EQ(part.kind, MeetingKind::overlap);
  EXPECT_EQ(part.overlap, (std::array<Point, 2>{Point{4, 4, 4}, Point{6, 6, 6}}));
  EXPECT_EQ(meet({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1, 1, 1}).at, (Point{1, 1, 1}));
  EXPECT_EQ(meet({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}).kind, MeetingKind::nothing);
  EXPECT_EQ(meet({0, 0, 0}, {1, 1, 1}, {0, 0, 1}, {1, 1, 2}).kind, MeetingKind::nothing);
}

// Moving and stretching does not change what meets; at the limits every product is as large as it
// can be.
TEST(Meet, IsExactUpToTheLargestCoordinates) {
  RandomStream random(2);
  const std::int64_t stretch = kMaxCoordinate / 2;
  for (int i = 0; i < 20000; ++i) {
    std::array<Point, 4> small;
    std::array<Point, 4> large;
    for (std::size_t k = 0; k < 4; ++k) {
      small[k] = random_point(random, 5);
      large[k] = Point{} + stretch * (small[k] - Point{2, 2, 2});
    }
    if (small[0] == small[1] || small[2] == small[3]) continue;
    const auto meets = [](const std::array<Point, 4>& p) { return meet(p[0], p[1], p[2], p[3]); };
    ASSERT_EQ(meets(small).kind, meets(large).kind);
    // One lattice step away from a proper crossing nothing may meet.
    if (meets(large).kind != MeetingKind::cross) continue;
    const auto n = cross(small[1] - small[0], small[3] - small[2]);
    if (n[2] == 0) continue;
    for (std::size_t k : {2u, 3u}) large[k].z += large[k].z > 0 ? -1 : 1;
    if (large[2].z - stretch * (small[2].z - 2) != large[3].z - stretch * (small[3].z - 2))
      continue;
    ASSERT_EQ(meets(large).kind, MeetingKind::nothing);
  }
}

TEST(OnSegment, IsExactUpToTheLargestCoordinates) {
  constexpr std::int64_t m = kMaxCoordinate;
  EXPECT_TRUE(on_segment({0, 0, 0}, {-m, -m, -m}, {m, m, m}));
  EXPECT_FALSE(on_segment({0, 0, 1}, {-m, -m, -m}, {m, m, m}));
  EXPECT_TRUE(on_segment({m, m, m}, {-m, -m, -m}, {m, m, m}));
  EXPECT_FALSE(on_segment({m, m, m}, {-m, -m, -m}, {m - 1, m - 1, m - 1}));
  EXPECT_FALSE(on_segment({1, 0, 0}, {-m, -m + 1, 0}, {m, m, 0}));
}

}  // namespace
}  // namespace ar3d::verify
