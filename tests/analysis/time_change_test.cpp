// The test behind every verdict on times, against brute force and published tables; then false
// alarms and power of the verdict, on simulated machines with a stated noise model.
// results/reference/rates.md quotes the rates that these tests print as properties.
#include "ar3d/analysis/compare/time_change.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "ar3d/base/random.h"
#include "synthetic.h"

namespace ar3d::testing {
namespace {

// P(W <= w) by all sign patterns.
double brute_force_tail(std::size_t pairs, std::size_t w) {
  std::size_t hits = 0;
  for (std::size_t signs = 0; signs < (std::size_t{1} << pairs); ++signs) {
    std::size_t sum = 0;
    for (std::size_t rank = 1; rank <= pairs; ++rank) sum += (signs >> (rank - 1) & 1) * rank;
    hits += sum <= w;
  }
  return static_cast<double>(hits) / std::ldexp(1.0, static_cast<int>(pairs));
}

TEST(SignedRank, TheExactDistributionIsThatOfAllSignPatterns) {
  for (const std::size_t pairs : {0u, 1u, 2u, 5u, 12u}) {
    const SignedRankDistribution distribution(pairs);
    for (std::size_t w = 0; w <= pairs * (pairs + 1) / 2; ++w) {
      EXPECT_DOUBLE_EQ(distribution.tail(w), brute_force_tail(pairs, w)) << pairs << " " << w;
    }
  }
}

TEST(SignedRank, CriticalValuesAreThoseOfThePublishedTable) {
  // Two-sided 5 %: Wilcoxon and Wilcox (1964), e.g. n = 10: 8, n = 15: 25, n = 20: 52.
  for (const auto& [pairs, critical] : {std::pair{6u, 0u}, {10u, 8u}, {15u, 25u}, {20u, 52u}}) {
    EXPECT_EQ(SignedRankDistribution(pairs).critical(0.025), critical) << pairs;
  }
  EXPECT_EQ(SignedRankDistribution(5).critical(0.025), std::nullopt);
}

TEST(SignedRank, TheNormalApproximationMeetsTheExactOne) {
  const SignedRankDistribution exact(100), normal(101);
  ASSERT_EQ(SignedRankDistribution::kExactPairs, 100u);
  for (const double p : {0.001, 0.01, 0.1}) {
    const auto below = exact.critical(p), above = normal.critical(p);
    ASSERT_TRUE(below && above);
    // 101 pairs have 101 more Walsh averages, about half of them on each side.
    EXPECT_NEAR(static_cast<double>(*above - *below), 101 / 2.0 - 12, 15) << p;
  }
}

TEST(SignedRank, EstimatesAndIntervalsMoveWithTheData) {
  const std::vector<double> values = {0.1, -0.3, 0.25, 0.7, 0.4, 0.05, -0.1, 0.33};
  std::vector<double> moved;
  for (const double value : values) moved.push_back(value + 2);
  const SignedRankDistribution distribution(values.size());
  const TimeVerdict test = signed_rank_test(values, distribution, 0.95);
  const TimeVerdict other = signed_rank_test(moved, distribution, 0.95);
  EXPECT_NEAR(other.estimate, test.estimate + 2, 1e-12);
  EXPECT_NEAR(other.interval.low, test.interval.low + 2, 1e-12);
  EXPECT_NEAR(other.interval.high, test.interval.high + 2, 1e-12);
  EXPECT_TRUE(test.interval.contains(test.estimate));
  EXPECT_DOUBLE_EQ(other.p_greater, std::ldexp(1.0, -8));  // all positive
  EXPECT_DOUBLE_EQ(other.p_value(), std::ldexp(1.0, -7));
}

TEST(SignedRank, ZerosAndTiesNeverHelp) {
  const std::vector<double> zeros(20, 0.0);
  const TimeVerdict test = signed_rank_test(zeros, SignedRankDistribution(20), 0.95);
  EXPECT_EQ(test.p_value(), 1);
  EXPECT_EQ(test.estimate, 0);
  const TimeVerdict none = signed_rank_test({}, SignedRankDistribution(0), 0.95);
  EXPECT_EQ(none.p_value(), 1);
  EXPECT_TRUE(std::isnan(none.estimate));
}

TEST(SignedRank, TheIntervalCoversTheCentreAsOftenAsItSays) {
  constexpr int kTrials = 4000;
  const SignedRankDistribution distribution(15);
  int covered = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    RandomStream random(7, static_cast<std::uint64_t>(trial));
    std::vector<double> values;
    for (int i = 0; i < 15; ++i) {
      const double scale = random.chance(1, 10) ? 20 : 1;  // heavy tails
      values.push_back(3 + scale * normal(random));
    }
    covered += signed_rank_test(values, distribution, 0.95).interval.contains(3);
  }
  // Exact confidence at 15 pairs: 95.2 %; four standard errors are 1.4 %.
  EXPECT_NEAR(static_cast<double>(covered) / kTrials, 0.952, 0.014);
}

TEST(BenjaminiHochberg, AdjustsAsInTheirPaper) {
  // The fifteen p-values of Benjamini and Hochberg (1995), section 3.2: four are rejected at 5 %.
  const std::vector<double> p = {0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344,
                                 0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.0000};
  const std::vector<double> adjusted = adjusted_p_values(p);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(adjusted[i] <= 0.05, i < 4) << i;
  EXPECT_NEAR(adjusted[0], 0.0015, 1e-12);
  EXPECT_NEAR(adjusted[3], 0.0095 * 15 / 4, 1e-12);
  EXPECT_TRUE(adjusted_p_values({}).empty());
}

constexpr std::size_t kCells = 240;
constexpr std::size_t kRounds = 19;
constexpr int kRepetitions = 5;

/// The stated noise model of a machine, for simulated comparisons: a time is its true value times
/// log-normal noise of 3 % a repetition; one repetition in ten is hit by a burst that multiplies it
/// by 1 + a Pareto number (index 1, from 0.1: in the mean infinite); a process is faster or slower
/// as a whole by log-normal 0.5 % (its memory layout); the machine drifts by a sine of +-10 % over
/// fifteen rounds and a random walk of 1 % a process, half of which an A meets before its B.
class MachineNoise {
 public:
  /// @param burst_percent  of the repetitions: 10 on a quiet machine, more on a loaded one.
  MachineNoise(std::uint64_t seed, std::uint64_t trial, std::uint32_t burst_percent = 10)
      : random_(seed, trial), burst_percent_(burst_percent) {}

  /// log(B / A) of every cell and round, the sides in turns, the smallest of kRepetitions each.
  /// @param slowdown  of B, by cell: log(true B / true A).
  std::vector<std::vector<double>> rounds(const std::vector<double>& slowdown) {
    std::vector<std::vector<double>> ratios(slowdown.size());
    for (std::size_t round = 0; round < kRounds; ++round) {
      const bool b_first = round % 2 == 1;
      const std::vector<double> first = process(slowdown.size());
      const std::vector<double> second = process(slowdown.size());
      for (std::size_t cell = 0; cell < slowdown.size(); ++cell) {
        const double gain = second[cell] - first[cell];
        ratios[cell].push_back(slowdown[cell] + (b_first ? -gain : gain));
      }
    }
    return ratios;
  }

 private:
  /// Log of the smallest time of every cell in one process.
  std::vector<double> process(std::size_t cells) {
    clock_ += 1;
    walk_ += 0.01 * normal(random_);
    const double drift = 0.1 * std::sin(2 * std::numbers::pi * clock_ / 30);
    const double layout = 0.005 * normal(random_);
    std::vector<double> smallest;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      double best = repetition();
      for (int i = 1; i < kRepetitions; ++i) best = std::min(best, repetition());
      smallest.push_back(best + drift + walk_ + layout + 0.005 * normal(random_));
    }
    return smallest;
  }

  double repetition() {
    const double noise = 0.03 * normal(random_);
    if (!random_.chance(burst_percent_, 100)) return noise;
    return noise + std::log1p(0.1 / (1 - random_.unit()));
  }

  RandomStream random_;
  std::uint32_t burst_percent_;
  double clock_ = 0;
  double walk_ = 0;
};

/// A trial of that many cells, B slower by `slowdown`.
std::vector<TimeVerdict> judged(std::uint64_t seed, std::uint64_t trial,
                                const std::vector<double>& slowdown,
                                std::uint32_t burst_percent = 10) {
  return judge_times(MachineNoise(seed, trial, burst_percent).rounds(slowdown), {});
}

std::size_t count(const std::vector<TimeVerdict>& verdicts, Verdict change) {
  return static_cast<std::size_t>(std::count_if(verdicts.begin(), verdicts.end(),
                                                [&](const auto& v) { return v.change == change; }));
}

TEST(TimeChange, AProgramAgainstItselfGivesNoMoreThanOneFalseAlarmInAThousandCells) {
  constexpr std::size_t kTrials = 400;
  std::size_t alarms = 0, passes = 0;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    const auto verdicts = judged(11, trial, std::vector<double>(kCells, 0));
    alarms += count(verdicts, Verdict::regressed) + count(verdicts, Verdict::improved);
    passes += count(verdicts, Verdict::pass);
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
    const auto verdicts = judged(12, trial, slowdown);
    const bool here = verdicts[trial % kCells].change == Verdict::regressed;
    found += here;
    others += count(verdicts, Verdict::regressed) + count(verdicts, Verdict::improved) - here;
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
        const auto verdicts = judged(16, trial, slowdown, bursts);
        slower += count(verdicts, Verdict::regressed);
        same += count(verdicts, Verdict::pass);
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
  const auto verdicts = judged(13, 0, slowdown);
  EXPECT_EQ(verdicts[3].change, Verdict::improved);
  EXPECT_EQ(verdicts[4].change, Verdict::pass);
}

TEST(TimeChange, TooFewPairsAreUndecided) {
  const CompareOptions rule;
  EXPECT_EQ(fewest_pairs(rule), 11u);
  EXPECT_EQ(fewest_pairs(rule, 240), 18u);
  const std::vector<double> clear(10, std::log(1.5));
  EXPECT_EQ(judge_times({clear}, rule)[0].change, Verdict::inconclusive);
  EXPECT_EQ(judge_times({std::vector<double>(11, std::log(1.5))}, rule)[0].change,
            Verdict::regressed);
  EXPECT_EQ(judge_times({{}}, rule)[0].change, Verdict::inconclusive);
  EXPECT_TRUE(judge_times({}, rule).empty());
}

TEST(TimeChange, ManyPairsAreThinnedNotRefused) {
  RandomStream random(5);
  std::vector<double> many;
  for (int i = 0; i < 50000; ++i) many.push_back(std::log(1.08) + 0.2 * normal(random));
  const TimeVerdict verdict = judge_times({many}, {})[0];
  EXPECT_EQ(verdict.change, Verdict::regressed);
  EXPECT_EQ(verdict.pairs, 2000u);
}

TEST(SmallestVisibleSlowdown, IsExactlyWhereTheVerdictTurns) {
  const CompareOptions rule;
  for (std::uint64_t trial = 0; trial < 20; ++trial) {
    const auto ratios = MachineNoise(14, trial).rounds({0.0});
    const double slowdown = smallest_visible_slowdown(ratios[0], rule, 1);
    for (const double sign : {-1.0, 1.0}) {
      std::vector<double> shifted;
      for (const double value : ratios[0]) {
        shifted.push_back(value + std::log1p(slowdown) + sign * 1e-9);
      }
      EXPECT_EQ(judge_times({shifted}, rule)[0].change == Verdict::regressed, sign > 0) << trial;
    }
  }
  EXPECT_EQ(smallest_visible_slowdown({0.0, 0.0}, rule, 1),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace ar3d::testing
