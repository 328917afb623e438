// Drawings that would take quadratic time to judge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ar3d/base/random.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/examination.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

/// An edge of nearly parallel segments that all lie beside each other, in many directions: none
/// meets another, and no cut parts them.
Draft zigzag(std::int64_t bends) {
  Draft draft;
  draft.vertices = {{-1, 1, 0}, {bends, -bends, 0}};
  draft.edges = {{{0, 1}, {}}};
  const std::int64_t far = 1000000;
  for (std::int64_t i = 0; i < bends; ++i) {
    const std::int64_t side = i % 2 * (far + 3 * i);
    draft.edges[0].bends.push_back({side + i, side - i, 0});
  }
  return draft;
}

TEST(HostileDrawings, JudgingGivesUpAtItsLimit) {
  const Draft draft = zigzag(3000);
  const auto judged = [&](std::uint64_t most) {
    return certify(draft.graph(), draft.drawing(), no_promise(), {.most_comparisons = most});
  };
  const Certificate whole = judged(0), cut = judged(10000), enough = judged(100000000);
  EXPECT_FALSE(whole.given_up);
  EXPECT_TRUE(cut.given_up);
  EXPECT_FALSE(cut.complete);
  EXPECT_FALSE(cut.valid());
  EXPECT_TRUE(cut.violated()) << "what was not judged is no pass";
  EXPECT_FALSE(enough.given_up);
  EXPECT_EQ(enough.valid(), whole.valid());
  EXPECT_EQ(enough.violations.size(), whole.violations.size());
}

/// The oracle: every pair.
double smallest_angle(const Draft& star) {
  double largest = -2;
  for (std::size_t i = 1; i < star.vertices.size(); ++i) {
    for (std::size_t j = 1; j < i; ++j) {
      const auto length = [](Point p) { return std::hypot(double(p.x), double(p.y), double(p.z)); };
      const Point &a = star.vertices[i], &b = star.vertices[j];
      const double product =
          double(a.x) * double(b.x) + double(a.y) * double(b.y) + double(a.z) * double(b.z);
      largest = std::max(largest, product / (length(a) * length(b)));
    }
  }
  return std::acos(std::min(largest, 1.0)) * 180 / 3.14159265358979323846;
}

Draft random_star(RandomStream& random, std::size_t leaves, std::int64_t height) {
  Draft star;
  star.vertices = {{0, 0, 0}};
  while (star.vertices.size() <= leaves) {
    const auto coordinate = [&random](std::int64_t reach) {
      return static_cast<std::int64_t>(random.below64(static_cast<std::uint64_t>(2 * reach + 1))) -
             reach;
    };
    const Point p{coordinate(1000), coordinate(1000), coordinate(height)};
    if (p == Point{0, 0, 0}) continue;
    star.edges.push_back({{0, static_cast<Vertex>(star.vertices.size())}, {}});
    star.vertices.push_back(p);
  }
  return star;
}

TEST(HostileDrawings, TheSmallestAngleAtACrowdedVertexIsThatOfAllPairs) {
  RandomStream random(1, 2);
  for (const std::int64_t height : {std::int64_t{1000}, std::int64_t{10}, std::int64_t{0}}) {
    for (const std::size_t leaves : {65u, 70u, 300u}) {
      const Draft star = random_star(random, leaves, height);
      DrawingSummary found;
      set_angles(star.drawing(), found);
      EXPECT_NEAR(found.smallest_vertex_angle, smallest_angle(star), 1e-5)
          << leaves << " leaves, height " << height;
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
