// The search for pairs that may meet against all pairs, and what it costs.
#include "ar3d/verify/crossings/near_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/verify/counting/columns.h"
#include "ar3d/verify/predicates/exact.h"

namespace ar3d::testing {
namespace {

using verify::SegmentInSpace;
using verify::SlantedSegment;

struct Shape {
  Point least;
  Vector room;   ///< of the first ends
  Vector reach;  ///< of the steps, either way
};

std::int64_t within(RandomStream& random, std::int64_t size) {
  return static_cast<std::int64_t>(random.below64(static_cast<std::uint64_t>(size) + 1));
}

SegmentInSpace segment(RandomStream& random, const Shape& shape) {
  const auto step = [&](std::int64_t reach) { return within(random, 2 * reach) - reach; };
  const Vector room{within(random, shape.room.x), within(random, shape.room.y),
                    within(random, shape.room.z)};
  return {shape.least + room, {step(shape.reach.x), step(shape.reach.y), step(shape.reach.z)}};
}

std::vector<SegmentInSpace> segments(RandomStream& random, const Shape& shape, std::size_t count) {
  std::vector<SegmentInSpace> list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(segment(random, shape));
  return list;
}

/// Clouds in which many pairs meet, or many nearly do; long, short, flat, steep and far ones.
const std::vector<Shape>& shapes() {
  const std::int64_t far = kMaxCoordinate;
  static const std::vector<Shape> list = {
      {{0, 0, 0}, {6, 6, 6}, {3, 3, 3}},
      {{0, 0, 0}, {30, 30, 30}, {2, 2, 2}},
      {{0, 0, 0}, {9, 9, 0}, {9, 9, 0}},
      {{0, 0, 0}, {40, 1, 100000}, {3, 1, 100000}},
      {{-20, -20, -20}, {40, 40, 40}, {40, 40, 40}},
      {{0, 0, 0}, {5, 5, 1000}, {0, 0, 60}},
      {{far - 40, far - 40, far - 40}, {20, 20, 20}, {20, 20, 20}},
      {{-far / 2, -far / 2, -far / 2}, {far, far, far}, {far / 2, far / 2, far / 2}},
      {{-far / 2, 0, 0}, {far, 3, 3}, {far / 2, 2, 2}}};
  return list;
}

bool meet(const SegmentInSpace& a, const SegmentInSpace& b) {
  const bool a_is_point = a.step == Vector{};
  const bool b_is_point = b.step == Vector{};
  if (a_is_point && b_is_point) return a.from == b.from;
  if (a_is_point) return verify::on_segment(a.from, b.from, b.from + b.step);
  if (b_is_point) return verify::on_segment(b.from, a.from, a.from + a.step);
  return verify::meet(a.from, a.from + a.step, b.from, b.from + b.step).kind !=
         verify::MeetingKind::nothing;
}

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Pairs all_that_meet(const std::vector<SegmentInSpace>& list) {
  Pairs pairs;
  for (std::uint32_t j = 0; j < list.size(); ++j) {
    for (std::uint32_t i = 0; i < j; ++i) {
      if (meet(list[i], list[j])) pairs.emplace(i, j);
    }
  }
  return pairs;
}

Pairs found(const std::vector<SegmentInSpace>& list, std::size_t few) {
  Pairs pairs;
  verify::for_each_near_pair(
      static_cast<std::uint32_t>(list.size()), [&](std::uint32_t i) { return list[i]; },
      [&](std::uint32_t i, std::uint32_t j) {
        pairs.emplace(std::min(i, j), std::max(i, j));
        return true;
      },
      few);
  return pairs;
}

TEST(NearPairs, HoldEveryPairThatMeets) {
  RandomStream random(21, 1);
  std::size_t meetings = 0;
  for (std::size_t i = 0; i < 9 * 12; ++i) {
    const auto list = segments(random, shapes()[i % 9], 60 + 10 * (i / 9));
    const Pairs wanted = all_that_meet(list);
    for (const std::size_t few : {2u, 5u, 48u}) {
      const Pairs near = found(list, few);
      ASSERT_TRUE(std::includes(near.begin(), near.end(), wanted.begin(), wanted.end()))
          << "shape " << i % 9 << ", cells of " << few;
    }
    meetings += wanted.size();
  }
  EXPECT_GT(meetings, 10000u);
}

/// Segments through one point, which all cuts near it keep.
TEST(NearPairs, MeetInOnePoint) {
  RandomStream random(2, 3);
  auto list = segments(random, {{0, 0, 0}, {0, 0, 0}, {500, 400, 300}}, 200);
  for (SegmentInSpace& s : list) s = {s.from + -s.step, 2 * s.step};
  EXPECT_EQ(found(list, 2).size(), list.size() * (list.size() - 1) / 2);
}

/// Just beside each other, in places where double has no digits left.
TEST(NearPairs, SkewIsSaidOnlyIfItIsSure) {
  const std::int64_t far = kMaxCoordinate;
  const SegmentInSpace a{{-far, -far, -far}, {2 * far, 2 * far, 2 * far}};
  const SegmentInSpace b{{-far, far, -far}, {2 * far, -2 * far, 2 * far}};
  EXPECT_FALSE(verify::surely_skew(a, b));
  EXPECT_FALSE(verify::surely_skew(a, {b.from + Vector{1, 0, 0}, b.step})) << "skew, but hardly";
  EXPECT_TRUE(verify::surely_skew(a, {{-far, far, -far / 2}, {2 * far, -2 * far, far / 2}}));
  EXPECT_TRUE(verify::surely_skew({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 1, 0}}));
  EXPECT_FALSE(verify::surely_skew({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {1, 1, 0}}));
  EXPECT_FALSE(verify::surely_skew({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 5}, {0, 0, 0}}));
}

std::uint64_t compared(const std::vector<SegmentInSpace>& list,
                       std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  return verify::for_each_near_pair(
      static_cast<std::uint32_t>(list.size()), [&](std::uint32_t i) { return list[i]; },
      [](std::uint32_t, std::uint32_t) { return true; }, 48, most);
}

TEST(NearPairs, FewComparisons) {
  RandomStream random(4, 5);
  const std::int64_t wide = 1 << 20;
  const Shape longest{{0, 0, 0}, {wide, wide, wide}, {wide, wide, wide}};
  const std::uint64_t few = compared(segments(random, longest, 4000));
  const std::uint64_t many = compared(segments(random, longest, 16000));
  EXPECT_LT(many, 12 * few) << "4^1.5 = 8, all pairs: 16";
  EXPECT_LT(many, std::uint64_t{16000} * 16000 / 20);
  const Shape shortest{{0, 0, 0}, {wide, wide, wide}, {wide / 100, wide / 100, wide / 100}};
  EXPECT_LT(compared(segments(random, shortest, 16000)), 16000u * 48);
}

TEST(NearPairs, NeverManyMoreThanAllPairs) {
  std::vector<SegmentInSpace> bundle;  // nothing tells these apart
  for (int i = 0; i < 2000; ++i) bundle.push_back({{0, 0, 0}, {1000, 1000, 1000 + i % 2}});
  EXPECT_LE(compared(bundle), 4u * 2000 * 2000 / 2);
  EXPECT_GT(compared(bundle), 1000000u);
  EXPECT_LE(compared(bundle, 1000000), 1000000u + bundle.size()) << "given up";
  EXPECT_EQ(compared({}), 0u);
}

/// As in drawings of degree 4, most segments long: the same counts by both ways.
TEST(NearPairs, CountTheSameMeetingsAsUpwards) {
  RandomStream random(6, 7);
  std::vector<SlantedSegment> list;
  while (list.size() < 1500) {
    const auto s = segment(random, {{0, 0, 0}, {60, 60, 4000}, {30, 30, 1000}});
    if (s.step.x == 0 && s.step.y == 0) continue;
    const Point low = s.step.z < 0 ? s.from + s.step : s.from;
    const Vector up = s.step.z < 0 ? -s.step : s.step;
    const auto narrow = [](std::int64_t c) { return static_cast<std::int32_t>(c); };
    list.push_back({narrow(low.x), narrow(low.y), low.z, narrow(up.x), narrow(up.y), up.z});
    if (list.size() % 3 == 0) {  // one that goes on from there
      list.push_back({narrow(low.x + up.x), narrow(low.y + up.y), low.z + up.z, narrow(up.y) + 1,
                      narrow(up.x), up.z});
    }
  }
  const auto upwards = verify::meetings_of_slanted(list, 1500);
  const auto halving = verify::meetings_of_slanted(list, 0);
  ASSERT_TRUE(upwards && halving);
  EXPECT_TRUE(*upwards == *halving);
  EXPECT_GT(halving->crossing, 400u);
}

TEST(NearPairs, CountingEndsWhereFarTooManyMeet) {
  std::vector<SlantedSegment> list;
  for (std::int32_t i = 0; i < 300; ++i) {
    list.push_back({i, -1, 0, 0, 400, 0});
    list.push_back({-1, i, 0, 400, 0, 0});
  }
  EXPECT_FALSE(verify::meetings_of_slanted(list, 0));
}

}  // namespace
}  // namespace ar3d::testing
