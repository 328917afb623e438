// The figures of docs/history.md: false alarms, steps found, places and effects covered, drifts.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "analysis/history_noise.h"
#include "ar3d/analysis/history/change_points.h"

namespace ar3d::testing {
namespace {

constexpr std::size_t kCommits = 50;

int alarms(const HistoryNoise& noise, double threshold, std::uint64_t trials) {
  int alarms = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const auto values = noise.series(1, trial, kCommits, [](std::size_t) { return 0.0; });
    alarms += find_changes(values, {.threshold = threshold}).empty() ? 0 : 1;
  }
  return alarms;
}

TEST(HistoryCalibration, AtMostOneFalseAlarmInAThousandCells) {
  constexpr std::uint64_t kCells = 10000;
  const int any = alarms({}, 0, kCells), counted = alarms({}, 0.02, kCells);
  std::printf("A/A, 50 commits: %d false alarms in %d cells; %d above 2 %%\n", any,
              static_cast<int>(kCells), counted);
  EXPECT_LE(any, 10 + 10);  // binomial with mean 10: beyond 20 once in 600 times
  EXPECT_LE(counted, 10);
  for (const double spread : {0.005, 0.02}) {
    const int seen = alarms({.spread = spread}, 0.02, kCells / 5);
    std::printf("A/A, spread %.1f %%: %d in %d\n", 100 * spread, seen,
                static_cast<int>(kCells / 5));
    EXPECT_LE(seen, 6);
  }
  for (const double kept : {0.3, 0.5}) {  // not promised: noise that remembers
    std::printf("A/A, %.0f %% of the noise stays: %d in %d\n", 100 * kept,
                alarms({.of_the_last = kept}, 0.02, kCells / 5), static_cast<int>(kCells / 5));
  }
}

struct StepCase {
  double step;
  double spread;
  std::size_t commits_behind;
  double least_found;  ///< 0: not promised
};

TEST(HistoryCalibration, SeededStepsAreFound) {
  constexpr int kTrials = 400;
  for (const StepCase& each : std::vector<StepCase>{{0.03, 0.005, 8, 0.95},
                                                    {0.03, 0.01, 8, 0},
                                                    {0.03, 0.01, 15, 0.95},
                                                    {0.03, 0.01, 25, 0.95},
                                                    {0.05, 0.01, 5, 0},
                                                    {0.05, 0.01, 8, 0.95},
                                                    {0.05, 0.01, 25, 0.95},
                                                    {0.05, 0.02, 25, 0},
                                                    {0.10, 0.01, 8, 0.95},
                                                    {0.10, 0.02, 8, 0.95},
                                                    {0.10, 0.02, 25, 0.95}}) {
    const std::size_t at = kCommits - each.commits_behind;
    int found = 0, covered = 0, effects = 0, extra = 0;
    for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
      const auto values = HistoryNoise{.spread = each.spread}.series(
          2, trial, kCommits, [&](std::size_t i) { return i >= at ? std::log1p(each.step) : 0.0; });
      bool is_found = false;
      for (const ChangePoint& change : find_changes(values, {})) {
        const bool is_it = !is_found && change.at + 2 >= at && change.at <= at + 2;
        extra += is_it ? 0 : 1;
        if (!is_it) continue;
        is_found = true;
        covered += change.first <= at && at <= change.last ? 1 : 0;
        effects += change.interval.contains(std::log1p(each.step)) ? 1 : 0;
      }
      found += is_found ? 1 : 0;
    }
    std::printf(
        "step %.0f %%, spread %.1f %%, %zu commits behind it: found %.1f %%, place covered "
        "%.1f %%, effect covered %.1f %%, other changes %d\n",
        100 * each.step, 100 * each.spread, each.commits_behind, 100.0 * found / kTrials,
        100.0 * covered / found, 100.0 * effects / found, extra);
    EXPECT_GE(found, each.least_found * kTrials) << each.step << ' ' << each.commits_behind;
    if (each.least_found > 0) {
      EXPECT_GE(covered, 0.95 * found);
      EXPECT_GE(effects, 0.91 * found);
      EXPECT_LE(extra, 0.04 * kTrials);
    }
  }
}

TEST(HistoryCalibration, DriftsAreSaidToBeGradual) {
  constexpr int kTrials = 400;
  for (const double drift : {0.03, 0.05, 0.10}) {
    int found = 0, changes = 0, gradual = 0;
    for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
      const auto values = HistoryNoise{}.series(3, trial, kCommits, [&](std::size_t i) {
        return drift * static_cast<double>(i) / kCommits;
      });
      const auto all = find_changes(values, {});
      found += all.empty() ? 0 : 1;
      for (const ChangePoint& change : all) {
        ++changes;
        gradual += change.gradual ? 1 : 0;
      }
    }
    std::printf(
        "drift of %.0f %% over 50 commits: a change in %.1f %% of the series; %.0f %% of "
        "the changes gradual\n",
        100 * drift, 100.0 * found / kTrials, 100.0 * gradual / std::max(changes, 1));
    if (drift >= 0.05) {
      EXPECT_GE(found, 0.9 * kTrials);
      EXPECT_GE(gradual, 0.7 * changes);
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
