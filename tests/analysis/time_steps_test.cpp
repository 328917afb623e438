// Times over results: what changed, what did not, and the rates that results/reference/rates.md states.
#include <cmath>
#include <cstdio>

#include "ar3d/analysis/history/history.h"
#include "synthetic.h"

namespace ar3d::testing {
namespace {

/// Settings of equally many cells. A level is normal noise of `spread` of the setting in the result
/// and as much of the cell; two in a hundred are a burst of log(1 + a Pareto number of index 1 from
/// 0.05).
struct Simulated {
  std::size_t settings = 3;
  std::size_t cells = 8;
  double spread = 0.01;

  std::vector<SideTimes> result(RandomStream& random, double step) const {
    std::vector<SideTimes> made;
    for (std::size_t setting = 0; setting < settings; ++setting) {
      const double of_setting = spread * normal(random) + (setting == 0 ? step : 0);
      for (std::size_t cell = 0; cell < cells; ++cell) {
        SideTimes times{.rounds = 12, .graphs = 3, .level = 0, .variance = 3e-6, .halves = 0};
        times.halves = 0.003 * normal(random);
        times.level = of_setting + spread * normal(random);
        if (random.chance(2, 100)) times.level += std::log1p(0.05 / (1 - random.unit()));
        made.push_back(times);
      }
    }
    return made;
  }

  /// @param step  the first setting is slower by it from result `at` on.
  TimeSeries series(std::uint64_t trial, std::size_t results, std::size_t at, double step) const {
    RandomStream random(41, trial);
    TimeSeries series;
    for (std::size_t i = 0; i < settings * cells; ++i) {
      series.settings.push_back("s" + std::to_string(i / cells));
    }
    series.yardsticks.resize(results);
    for (std::size_t i = 0; i < results; ++i) {
      series.results.push_back(result(random, i < at ? 0 : std::log1p(step)));
    }
    return series;
  }
};

TEST(TimeSteps, NothingIsFoundWhereNothingChanged) {
  std::size_t values = 0;
  for (const Simulated& kind : {Simulated{}, Simulated{.settings = 1, .cells = 24},
                                Simulated{.spread = 0.005}, Simulated{.settings = 2, .cells = 1}}) {
    for (const std::size_t results : {2U, 4U, 6U, 8U, 12U, 50U}) {
      for (std::uint64_t trial = 0; trial < 2700 / results; ++trial) {
        const TimeSeries series = kind.series(trial, results, 0, 0);
        EXPECT_THAT(find_time_steps(series, {}).first, IsEmpty()) << results << ' ' << trial;
        values += results * series.settings.size();
      }
    }
  }
  std::printf("%zu values without a change\n", values);
}

TEST(TimeSteps, StepsAreFoundAtTheirPlace) {
  constexpr int kTrials = 100;
  for (const auto& [results, step, least] :
       std::vector<std::tuple<std::size_t, double, int>>{{4, 0.1, 40},
                                                         {4, 0.2, 98},
                                                         {4, 0.5, 100},
                                                         {6, 0.1, 75},
                                                         {6, 0.2, 98},
                                                         {6, 0.5, 100},
                                                         {8, 0.1, 75},
                                                         {8, 0.15, 98},
                                                         {8, 0.5, 100},
                                                         {12, 0.1, 80},
                                                         {12, 0.15, 98},
                                                         {12, 0.5, 100}}) {
    int found = 0;
    for (std::uint64_t trial = 0; trial < kTrials; ++trial) {
      const auto steps =
          find_time_steps(Simulated{}.series(trial, results, results / 2, step), {}).first;
      found += std::ranges::any_of(steps, [&, results = results](const TimeStep& one) {
        return one.at == results / 2 && one.setting == "s0" && one.cell == kNoCell;
      });
    }
    std::printf("%zu results, %2.0f %% slower: found in %d of %d\n", results, 100 * step, found,
                kTrials);
    EXPECT_GE(found, least) << results << ' ' << step;
  }
}

/// One setting of 24 cells, whose times in results are these.
TimeSeries measured(const std::vector<double>& times) {
  TimeSeries series;
  series.settings.assign(24, "own");
  for (const double time : times) {
    series.yardsticks.emplace_back();
    series.results.emplace_back();
    for (int cell = 0; cell < 24; ++cell) {
      series.results.back().push_back({.rounds = 12,
                                       .graphs = 1,
                                       .level = std::log(time) + cell,
                                       .variance = 1e-6,
                                       .halves = 0});
    }
  }
  return series;
}

// A program of a user, half as slow again from the sixth commit on, on a noisy machine.
TEST(TimeSteps, HalfAsSlowAgainIsFoundFromFourResultsOn) {
  const std::vector<double> times = {30.1, 30.7, 29.2, 32.5, 29.8, 45.0, 44.7, 45.3, 45.9, 45.2};
  constexpr std::size_t kStep = 5;
  for (std::size_t begin = 0; begin + 2 <= kStep; ++begin) {
    for (std::size_t end = kStep + 2; end <= times.size(); ++end) {
      const TimeSeries series = measured({times.begin() + static_cast<std::ptrdiff_t>(begin),
                                          times.begin() + static_cast<std::ptrdiff_t>(end)});
      const auto [steps, smallest] = find_time_steps(series, {});
      ASSERT_THAT(steps, SizeIs(1)) << begin << ' ' << end;
      EXPECT_EQ(steps[0].at, kStep - begin);
      EXPECT_NEAR(std::exp(steps[0].change), 1.5, 0.15);
      EXPECT_LE(smallest[0].best, steps[0].change);
    }
  }
}

TEST(TimeSteps, AChangeForOneResultOfFewCellsIsNone) {
  TimeSeries series = measured({30, 30, 30, 30, 30, 60, 30, 30, 30, 30});
  series.settings.assign(1, "own");
  for (auto& result : series.results) result.resize(1);
  EXPECT_THAT(find_time_steps(series, {}).first, IsEmpty());
}

TEST(TimeSteps, ASingleCellAndAllSettingsTogetherAreFound) {
  TimeSeries series = Simulated{.spread = 0.002}.series(1, 10, 10, 0);
  for (std::size_t i = 5; i < 10; ++i) series.results[i][7].level += 0.5;
  auto steps = find_time_steps(series, {}).first;
  ASSERT_THAT(steps, SizeIs(1));
  EXPECT_EQ(steps[0].cell, 7U);
  EXPECT_EQ(steps[0].at, 5U);
  series = Simulated{.spread = 0.002}.series(1, 10, 10, 0);
  for (std::size_t i = 4; i < 10; ++i) {
    for (SideTimes& cell : series.results[i]) cell.level += 0.5;
  }
  steps = find_time_steps(series, {}).first;
  ASSERT_THAT(steps, SizeIs(1));
  EXPECT_EQ(steps[0].setting, "");
  EXPECT_EQ(steps[0].at, 4U);
}

TEST(TimeSteps, WhatResultsCanShowIsSaid) {
  const auto of = [](std::size_t results, std::size_t cells) {
    return find_time_steps(Simulated{.cells = cells}.series(3, results, results, 0), {})
        .second.at(0);
  };
  EXPECT_TRUE(std::isnan(of(1, 8).best));
  EXPECT_TRUE(std::isnan(of(7, 2).best));  // few cells need four results on either side
  EXPECT_FALSE(std::isnan(of(8, 2).best));
  EXPECT_TRUE(std::isnan(of(8, 2).at_once));
  EXPECT_LT(of(12, 8).best, of(4, 8).best);
  EXPECT_LE(of(12, 8).best, of(12, 8).at_once);
  EXPECT_EQ(of(12, 8).cells, 8U);
  EXPECT_EQ(of(12, 8).results, 12U);
}

}  // namespace
}  // namespace ar3d::testing
