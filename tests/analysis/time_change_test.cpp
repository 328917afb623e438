// False alarms and power of the verdict on times, on simulated machines with a stated noise model.
// docs/analysis.md quotes the rates that these tests print as properties.
#include "ar3d/analysis/compare/time_change.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "machine_noise.h"

namespace ar3d::testing {
namespace {

constexpr std::size_t kCells = 240;
constexpr std::size_t kRounds = 15;
constexpr int kRepetitions = 5;

std::size_t count(const std::vector<TimeVerdict>& verdicts, TimeChange change) {
  return static_cast<std::size_t>(std::count_if(verdicts.begin(), verdicts.end(),
                                                [&](const auto& v) { return v.change == change; }));
}

TEST(TimeChange, AProgramAgainstItselfGivesNoMoreThanOneFalseAlarmInAThousandCells) {
  constexpr std::size_t kTrials = 400;
  std::size_t alarms = 0, passes = 0;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    const auto ratios =
        MachineNoise(11, trial).rounds(std::vector<double>(kCells, 0), kRounds, kRepetitions);
    const auto verdicts = judge_times(ratios, {});
    alarms += count(verdicts, TimeChange::slower) + count(verdicts, TimeChange::faster);
    passes += count(verdicts, TimeChange::same);
  }
  RecordProperty("false_alarms", static_cast<int>(alarms));
  RecordProperty("passes", static_cast<int>(passes));
  RecordProperty("cells", static_cast<int>(kCells * kTrials));
  EXPECT_LE(alarms, kCells * kTrials / 1000);
}

TEST(TimeChange, TenPercentInOneCellAmongAllAreFoundNinetyNineTimesOfAHundred) {
  constexpr std::size_t kTrials = 500;
  std::size_t found = 0, others = 0;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    std::vector<double> slowdown(kCells, 0);
    slowdown[trial % kCells] = std::log(1.10);
    const auto verdicts =
        judge_times(MachineNoise(12, trial).rounds(slowdown, kRounds, kRepetitions), {});
    const bool here = verdicts[trial % kCells].change == TimeChange::slower;
    found += here;
    others += count(verdicts, TimeChange::slower) + count(verdicts, TimeChange::faster) - here;
  }
  RecordProperty("found", static_cast<int>(found));
  RecordProperty("trials", static_cast<int>(kTrials));
  RecordProperty("others", static_cast<int>(others));
  EXPECT_GE(found * 100, kTrials * 99);
  EXPECT_LE(others, kCells * kTrials / 1000);
}

/// Builds that take turns, slower by so many per cent, quiet and loaded (half of the repetitions
/// hit by bursts). Prints the rates.
TEST(TimeChange, ASlowerBuildNeverPassesUnnoticed) {
  constexpr std::size_t kTrials = 20;
  for (const std::uint32_t bursts : {10U, 50U}) {
    for (const double percent : {3.0, 5.0, 10.0, 20.0, 50.0}) {
      std::size_t slower = 0, same = 0;
      for (std::size_t trial = 0; trial < kTrials; ++trial) {
        const std::vector<double> slowdown(kCells, std::log1p(percent / 100));
        MachineNoise machine(16, trial, bursts);
        const auto verdicts = judge_times(machine.rounds(slowdown, kRounds, kRepetitions), {});
        slower += count(verdicts, TimeChange::slower);
        same += count(verdicts, TimeChange::same);
      }
      std::printf("%4.0f %% slower, %u %% bursts: slower %zu, same %zu of %zu cells\n", percent,
                  bursts, slower, same, kCells * kTrials);
      if (percent >= 5) {
        EXPECT_LE(same * 100, kCells * kTrials * 5) << percent << " " << bursts;
      }
      if (percent >= 10) {
        EXPECT_EQ(same, 0U) << percent << " " << bursts;
      }
      if (percent >= 20) {
        EXPECT_GE(slower * 100, kCells * kTrials * 99) << percent << " " << bursts;
      }
    }
  }
}

TEST(TimeChange, TenPercentFasterIsAnImprovementAndTwoPercentArePassed) {
  std::vector<double> slowdown(kCells, 0);
  slowdown[3] = -std::log(1.10);
  slowdown[4] = std::log(1.01);
  const auto verdicts =
      judge_times(MachineNoise(13, 0).rounds(slowdown, kRounds, kRepetitions), {});
  EXPECT_EQ(verdicts[3].change, TimeChange::faster);
  EXPECT_EQ(verdicts[4].change, TimeChange::same);
}

TEST(TimeChange, TooFewPairsAreUndecided) {
  const TimeRule rule;
  EXPECT_EQ(fewest_pairs(rule), 11u);
  EXPECT_EQ(fewest_pairs(rule, 240), 14u);
  const std::vector<double> clear(10, std::log(1.5));
  EXPECT_EQ(judge_times({clear}, rule)[0].change, TimeChange::undecided);
  EXPECT_EQ(judge_times({std::vector<double>(11, std::log(1.5))}, rule)[0].change,
            TimeChange::slower);
  EXPECT_EQ(judge_times({{}}, rule)[0].change, TimeChange::undecided);
  EXPECT_TRUE(judge_times({}, rule).empty());
}

TEST(TimeChange, ManyPairsAreThinnedNotRefused) {
  RandomStream random(5);
  std::vector<double> many;
  for (int i = 0; i < 50000; ++i) many.push_back(std::log(1.08) + 0.2 * normal(random));
  const TimeVerdict verdict = judge_times({many}, {})[0];
  EXPECT_EQ(verdict.change, TimeChange::slower);
  EXPECT_EQ(verdict.test.pairs, 2000u);
}

TEST(SmallestVisibleSlowdown, IsExactlyWhereTheVerdictTurns) {
  const TimeRule rule;
  for (std::uint64_t trial = 0; trial < 20; ++trial) {
    const auto ratios = MachineNoise(14, trial).rounds({0.0}, kRounds, kRepetitions);
    const double slowdown = smallest_visible_slowdown(ratios[0], rule, 1);
    for (const double sign : {-1.0, 1.0}) {
      std::vector<double> shifted;
      for (const double value : ratios[0]) {
        shifted.push_back(value + std::log1p(slowdown) + sign * 1e-9);
      }
      EXPECT_EQ(judge_times({shifted}, rule)[0].change == TimeChange::slower, sign > 0) << trial;
    }
  }
  EXPECT_EQ(smallest_visible_slowdown({0.0, 0.0}, rule, 1),
            std::numeric_limits<double>::infinity());
}

TEST(Calibration, StatesFalseAlarmsAndWhatIsVisible) {
  const auto ratios =
      MachineNoise(15, 0).rounds(std::vector<double>(kCells, 0), kRounds, kRepetitions);
  const Calibration calibration = calibrate(ratios, {}, 100);
  EXPECT_EQ(calibration.cells, kCells);
  EXPECT_EQ(calibration.pairs, kRounds);
  EXPECT_LE(calibration.false_alarm_rate(), 0.001);
  EXPECT_GE(calibration.smallest_slowdown_median, 0.05);
  EXPECT_LT(calibration.smallest_slowdown_median, 0.10);
  EXPECT_GE(calibration.smallest_slowdown_worst, calibration.smallest_slowdown_median);

  const Calibration few = calibrate({{0.1, 0.2}}, {}, 10);
  EXPECT_TRUE(std::isinf(few.smallest_slowdown_median));
  EXPECT_EQ(calibrate({}, {}, 10).cells, 0u);
}

}  // namespace
}  // namespace ar3d::testing
