// Step E.2, the comparison of two segments; Lemmas E.4 and E.6: angles and sizes at every scale.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "algorithms/two_bend_109_support.h"
#include "ar3d/algorithms/two_bend_109/drawn_segments.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/algorithms/two_bend_109/slots.h"
#include "ar3d/algorithms/two_bend_109/stubs.h"
#include "ar3d/algorithms/two_bend_109/two_bend_109.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"
#include "ar3d/verify/predicates/exact.h"
#include "support/graphs.h"

namespace ar3d::two_bend_109 {
namespace {

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
  std::map<SlotSpot, int> seen;
  for (const Graph& graph : testing::geng("-c -D4 7")) {
    for (const SlotSpot spot : arrange(testing::ordered(graph)).spot) ++seen[spot];
  }
  EXPECT_GT(seen[SlotSpot::centre], 0);
  EXPECT_GT(seen[SlotSpot::left_inside], 0);
}

TEST(TwoBend109Crossings, TwoSegmentsMeetIffTheVerifierSaysSo) {
  RandomStream random(5);
  const auto point = [&](std::uint32_t size) {
    return Point{random.below(size), random.below(size), random.below(size)};
  };
  int met = 0;
  for (int i = 0; i < 40000; ++i) {
    const std::uint32_t size = 2 + static_cast<std::uint32_t>(i % 5);
    const LatticeSegment a{point(size), point(size)};
    const LatticeSegment b{point(size), point(size)};
    if (a.from == a.to || b.from == b.to) continue;
    const bool said = meet(a, b);
    const verify::Meeting meeting = verify::meet(a.from, a.to, b.from, b.to);
    EXPECT_EQ(said, meeting.kind != verify::MeetingKind::nothing);
    EXPECT_EQ(said, meet(b, a));
    EXPECT_EQ(said, meet({a.to, a.from}, b));
    met += said ? 1 : 0;
  }
  EXPECT_GT(met, 1000);
}

TEST(TwoBend109Crossings, LargeCoordinatesAreExact) {
  const std::int64_t far = std::int64_t{1} << 60;
  // Two lines that cross in one lattice point, and the same with one end moved by one.
  const LatticeSegment a{{-far, 0, -far}, {far, 2, far}};
  const LatticeSegment b{{far, 0, -far}, {-far, 2, far}};
  EXPECT_TRUE(meet(a, b));
  EXPECT_FALSE(meet(a, {{far, 0, -far}, {-far, 3, far}}));
  EXPECT_FALSE(meet({{-far, 0, -far}, {far, 2, far - 1}}, {{far, 0, -far}, {-far, 2, far - 2}}));
}

constexpr double kDegree = std::numbers::pi / 180;

/// sqrt 3 times the largest ratio over J of (a J + b) / (c J + d).
double ratio(double a, double b, double c, double d) {
  double largest = 0;
  for (double j = 1; j < 1e9; j *= 1.1) largest = std::max(largest, (a * j + b) / (c * j + d));
  return std::sqrt(3.0) * largest;
}

// The end of Lemma E.6 for few vertices: the largest sum over all ways to divide n into components.
TEST(TwoBend109Scale, SumsOfComponentsFitTheBox) {
  std::array<std::int64_t, 67> largest{};
  const AxisBound bound = row().guarantee.bound.axes[0];
  for (std::int64_t n = 1; n < 67; ++n) {
    std::int64_t& sum = largest[static_cast<std::size_t>(n)];
    for (std::int64_t k = 1; k <= n; ++k) {
      const std::int64_t jitter = LayoutScale::always_enough(static_cast<std::uint64_t>(k)).jitter;
      const std::int64_t one = k * (20 * jitter + 925) + 1 + (k >= 4 ? 81650 : 0);
      EXPECT_LE(one, 360 * k * k + 1406 * k + (k >= 4 ? 81650 : 0));
      sum = std::max(sum, largest[static_cast<std::size_t>(n - k)] + one);
    }
    EXPECT_TRUE(bound.holds(sum, static_cast<std::uint64_t>(n))) << n;
  }
  EXPECT_TRUE(bound.holds(360 * 67 * 67 + 21819 * 67, 67));
}

TEST(TwoBend109Scale, HeightAndDepthFitTheBox) {
  const std::array<AxisBound, 3> axes = row().guarantee.bound.axes;
  for (double n = 1; n < 1e9; n = std::floor(1 + n * 1.001)) {
    const auto jitter =
        static_cast<double>(LayoutScale::always_enough(static_cast<std::uint64_t>(n)).jitter);
    EXPECT_LE(13 * jitter + 582 + 36628, axes[1].value(static_cast<std::uint64_t>(n))) << n;
    const double others = n * (150 * n * jitter + 6938 * n + 305 * jitter + 13966);
    const double bodies = 8400 * n * jitter + 388500 * n + 5600 * jitter + 4.3e7 + 81744 * n / 4;
    EXPECT_LE(others + bodies + 42, axes[2].value(static_cast<std::uint64_t>(n))) << n;
    if (n <= 75000) {
      EXPECT_LT(others + bodies + 42, 0x1p60);
    }
    if (n <= 1e7) {  // the widths of a small square
      const double small = n * (150 * n * 16 + 6938 * n + 305 * 16 + 13966);
      EXPECT_LT(small + 8400 * n * 16 + 388500 * n + 5600 * 16 + 4.3e7 + 81744 * n / 4 + 42,
                0x1p60);
    }
  }
}

TEST(TwoBend109Scale, TheTheoremsBoxFits32BitsUpTo72Vertices) {
  const AxisBound height = row().guarantee.bound.axes[2];
  EXPECT_LT(height.value(72), 0x1p31);
  EXPECT_GT(height.value(73), 0x1p31);
}

TEST(TwoBend109Scale, DoublesUpToTheProofs) {
  LayoutScale scale{16};
  std::vector<std::int64_t> jitters;
  for (; scale != LayoutScale::always_enough(10); scale = scale.next(10)) {
    EXPECT_LE(scale.jitter, scale.body_jitter);
    jitters.push_back(scale.jitter);
  }
  EXPECT_THAT(jitters, ::testing::ElementsAre(16, 32, 64, 128));
  for (std::uint64_t n = 0; n < 100; ++n) {
    const LayoutScale most = LayoutScale::always_enough(n);
    EXPECT_LE(most.jitter, most.body_jitter);
    EXPECT_LE(most.body_jitter, 2 * most.jitter + 16);
    EXPECT_EQ(most.next(n), most);
  }
}

TEST(TwoBend109Scale, KeepsEveryAngleOfLemmaE4) {
  EXPECT_LE(ratio(1, 11, 4, 74), 0.47);
  EXPECT_LE(ratio(4, 131, 15, 750), 0.47);
  EXPECT_LE(ratio(7, 291, 27, 1269), 0.47);
  EXPECT_LT(std::atan(0.47) / kDegree, 26.7);
  for (std::int64_t jitter = 1; jitter < 1'000'000'000; jitter += 1 + jitter / 7) {
    const LayoutScale scale{jitter};
    const auto j = static_cast<double>(jitter);
    // What the lemma says of ports follows from the lengths of the scale.
    EXPECT_GE(scale.gap(SlotKind::single) - (jitter - 1) - kStubX - 2, 4 * jitter + 74);
    EXPECT_GE(scale.gap(SlotKind::cycle) - (jitter - 1) - 9 - 2, 15 * jitter + 750);
    EXPECT_LE(scale.half_pair() + (jitter - 1) + 1 + 6, 4 * jitter + 131);
    EXPECT_GE(scale.gap(SlotKind::triangle) - 2 * scale.radius() - (jitter - 1) - kStubX - 2,
              27 * jitter + 1269);
    EXPECT_LE(scale.radius() + (jitter - 1) + kStubY + 1, 7 * jitter + 291);
    EXPECT_GE(scale.gap(SlotKind::cycle) - (jitter - 1) - 18, 15 * jitter + 743);
    EXPECT_GE(2 * scale.half_pair() - (jitter - 1) - 12, 5 * jitter + 239);
    const double along =
        std::sqrt(6 * (j + 7) * (j + 7) + 98 * 98) / (std::sqrt(2.0) * (15 * j + 743));
    EXPECT_LE(std::atan(along) / kDegree, 6.7);
    const double across =
        std::sqrt(2 * (j + 3) * (j + 3) + 42 * 42) / (std::sqrt(6.0) * (5 * j + 239));
    EXPECT_LE(std::atan(across) / kDegree, 6.7);
    const auto r = static_cast<double>(scale.radius());
    EXPECT_LE(std::atan((2.83 * j + 154) / (4.89 * r - 2.83 * j - 66)) / kDegree, 6.8);
    // Inside a triangle: from place to place, and how far jitter and two stubs shift that. A stub
    // is at most 39 long seen from above, those of three down 2.83.
    const auto off = [&](double dx, double dy, double stubs) {
      const double length = std::sqrt(2 * dx * dx + 6 * dy * dy);
      return std::asin((std::sqrt(8.0) * (j - 1) + stubs) / length) / kDegree;
    };
    const double left = std::atan2(std::sqrt(6.0), -std::sqrt(2.0) / 2) / kDegree;
    EXPECT_LE(off(2 * r, 0, 39 + 2.83), 10) << "from the centre to a corner";
    EXPECT_LE(120 - left + off(r / 2, r, 39 + 2.83), 25) << "from the offset one to a left corner";
    EXPECT_LE(off(r / 2, 0, 2.83), 42) << "from the offset one to the centre";
  }
}

}  // namespace
}  // namespace ar3d::two_bend_109
