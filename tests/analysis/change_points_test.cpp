// Changes of level in series: where they are, how large, and what is none.
#include "ar3d/analysis/history/change_points.h"

#include <cmath>

#include "analysis/history_noise.h"
#include "support/test.h"

namespace ar3d::testing {
namespace {

const auto kLevel = [](std::size_t) { return 0.0; };

TEST(ChangePoints, AConstantOrAShortSeriesHasNone) {
  EXPECT_THAT(find_changes({}, {}), IsEmpty());
  EXPECT_THAT(find_changes(std::vector<double>(50, 1.5), {}), IsEmpty());
  EXPECT_THAT(find_changes(std::vector<double>{0, 0, 0, 9, 9, 9, 9}, {}), IsEmpty());
}

TEST(ChangePoints, AStepWithoutNoiseIsFoundAtItsPlaceWithItsEffect) {
  std::vector<double> values(20, 0.0);
  for (std::size_t i = 12; i < 20; ++i) values[i] = 0.1;
  const auto changes = find_changes(values, {});
  ASSERT_THAT(changes, SizeIs(1));
  EXPECT_EQ(changes[0].at, 12U);
  EXPECT_DOUBLE_EQ(changes[0].effect, 0.1);
  EXPECT_DOUBLE_EQ(changes[0].interval.low, 0.1);
  EXPECT_FALSE(changes[0].gradual);
  EXPECT_LE(changes[0].first, 12U);
  EXPECT_GE(changes[0].last, 12U);
}

TEST(ChangePoints, ThereAndBackAreTwoChanges) {
  const auto changes =
      find_changes(HistoryNoise{.spread = 0.005}.series(
                       1, 1, 50, [](std::size_t i) { return i >= 20 && i < 35 ? 0.05 : 0.0; }),
                   {});
  ASSERT_THAT(changes, SizeIs(2));
  EXPECT_NEAR(static_cast<double>(changes[0].at), 20, 1);
  EXPECT_NEAR(static_cast<double>(changes[1].at), 35, 1);
  EXPECT_GT(changes[0].effect, 0.03);
  EXPECT_LT(changes[1].effect, -0.03);
}

TEST(ChangePoints, ADriftIsGradual) {
  const auto changes =
      find_changes(HistoryNoise{.spread = 0.002, .burst_percent = 0}.series(
                       1, 1, 50, [](std::size_t i) { return 0.1 * static_cast<double>(i) / 50; }),
                   {});
  ASSERT_FALSE(changes.empty());
  for (const ChangePoint& change : changes) EXPECT_TRUE(change.gradual) << change.at;
}

TEST(ChangePoints, BurstsAndSmallChangesAreNone) {
  std::vector<double> bursts = HistoryNoise{.spread = 0.005}.series(2, 1, 50, kLevel);
  bursts[10] += 1, bursts[30] += 3, bursts[49] += 2;
  EXPECT_THAT(find_changes(bursts, {}), IsEmpty());
  const auto small = [](std::size_t i) { return i < 25 ? 0.0 : 0.01; };
  const auto quiet = HistoryNoise{.spread = 0.001}.series(2, 1, 50, small);
  EXPECT_THAT(find_changes(quiet, {}), IsEmpty());
  EXPECT_THAT(find_changes(quiet, {.threshold = 0.005}), SizeIs(1));
}

TEST(ChangePoints, EqualSeedsGiveEqualResults) {
  const auto step = [](std::size_t i) { return i < 25 ? 0.0 : 0.02; };
  const auto values = HistoryNoise{}.series(3, 1, 50, step);
  const auto a = find_changes(values, {}), b = find_changes(values, {});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].at, b[i].at);
}

TEST(ChangePoints, WithoutNoiseEveryChangeAboveTheThresholdCounts) {
  const auto changes = find_exact_changes(std::vector<double>{0, 0, 0.5, 0.5, 0.504, 0.493}, 0.01);
  ASSERT_THAT(changes, SizeIs(1));
  EXPECT_EQ(changes[0].at, 2U);
  EXPECT_EQ(changes[0].first, 2U);
  EXPECT_DOUBLE_EQ(changes[0].effect, 0.5);
}

TEST(ChangePoints, SmallChangesThatAddUpAreAGradualOne) {
  const auto changes = find_exact_changes(std::vector<double>{0, 0.004, 0.008, 0.012, 0.012}, 0.01);
  ASSERT_THAT(changes, SizeIs(1));
  EXPECT_TRUE(changes[0].gradual);
  EXPECT_EQ(changes[0].first, 1U);
  EXPECT_EQ(changes[0].last, 3U);
}

TEST(ChangePoints, TheShiftIsTheMedianDifference) {
  const std::vector<double> before = {1, 2, 3}, after = {11, 12, 14};
  const Shift shift = shift_between(before, after, 0.95);
  EXPECT_DOUBLE_EQ(shift.estimate, 10);  // of 8 9 9 10 10 11 11 12 13
  EXPECT_DOUBLE_EQ(shift.interval.low, 8);
  EXPECT_DOUBLE_EQ(shift.interval.high, 13);
}

TEST(Split, WinsorisingMovesWhatStandsFarOutAndNothingElse) {
  const std::vector<double> values = {0, 1, 0, 1, 0, 1, 0, 100};
  const std::vector<double> clipped = winsorised(values);
  EXPECT_THAT(std::vector<double>(clipped.begin(), clipped.end() - 1),
              ElementsAre(0, 1, 0, 1, 0, 1, 0));
  EXPECT_NEAR(clipped.back(), 0.5 + 3 * 1.4826 / std::sqrt(2), 1e-12);
}

TEST(Split, SeededIntervalsCoverEveryPlaceInEveryLayer) {
  const SeededIntervals intervals = seeded_intervals(50, 8);
  EXPECT_EQ(intervals.front(), (std::pair<std::size_t, std::size_t>(0, 50)));
  for (std::size_t place = 1; place < 50; ++place) {
    std::size_t shortest = 50;
    for (const auto& [begin, end] : intervals) {
      EXPECT_LE(end, 50U);
      EXPECT_GE(end - begin, 8U);
      if (begin < place && place < end) shortest = std::min(shortest, end - begin);
    }
    EXPECT_LE(shortest, 10U) << place;
  }
}

/// What largest_split() has to find, by its definition.
double height_at(std::span<const double> values, std::size_t at) {
  const auto a = static_cast<double>(at), b = static_cast<double>(values.size() - at);
  return std::abs(mean(values.first(at)) - mean(values.subspan(at))) * std::sqrt(a * b / (a + b));
}

TEST(Split, TheHighestIsThatOfTheDefinition) {
  const auto values = HistoryNoise{}.series(4, 1, 30, kLevel);
  const Split split = largest_split(values, {{0, 30}}, 4);
  double best = 0;
  for (std::size_t at = 4; at <= 26; ++at) best = std::max(best, height_at(values, at));
  EXPECT_NEAR(split.height, best, 1e-12);
  EXPECT_NEAR(height_at(values, split.at), best, 1e-12);
}

}  // namespace
}  // namespace ar3d::testing
