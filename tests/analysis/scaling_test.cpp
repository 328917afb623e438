#include "ar3d/analysis/scaling/scaling.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "analysis/synthetic.h"

namespace ar3d::testing {
namespace {

using Law = std::function<double(double n)>;

double n_itself(double n) { return std::log(n); }

/// Sizes whose graphs have truth(n), a logarithm, and normal noise of that spread.
std::vector<SizeSample> sizes_of(const std::vector<std::int64_t>& sizes, std::size_t graphs,
                                 const Law& truth, double noise = 0) {
  RandomStream random(11);
  std::vector<SizeSample> samples;
  for (const std::int64_t n : sizes) {
    SizeSample& sample = samples.emplace_back();
    sample.n = n;
    for (std::size_t i = 0; i < graphs; ++i) {
      sample.instances.push_back({truth(static_cast<double>(n)) + noise * normal(random), i});
    }
  }
  return samples;
}

/// So many sizes, each twice the one before.
std::vector<std::int64_t> doubling(std::int64_t first, std::size_t count) {
  std::vector<std::int64_t> sizes;
  for (std::size_t i = 0; i < count; ++i) sizes.push_back(first << i);
  return sizes;
}

ScalingEntry fit(const std::vector<std::int64_t>& sizes, std::size_t graphs, const Law& truth,
                 double noise = 0) {
  return fit_scaling(sizes_of(sizes, graphs, truth, noise));
}

std::vector<ScalingEntry> scaling(const Results& results) {
  return ar3d::scaling(tally_of(results));
}

TEST(LinearFit, RecoversAnExactPlane) {
  std::vector<std::vector<double>> x;
  std::vector<double> y;
  for (int i = 0; i < 6; ++i) {
    x.push_back({1, 1.0 * i, 1.0 * i * i});
    y.push_back(2 - 3 * x[x.size() - 1][1] + 0.5 * x[x.size() - 1][2]);
  }
  const LinearFit fit = fit_linear(x, y);
  EXPECT_NEAR(fit.coefficients[0], 2, 1e-10);
  EXPECT_NEAR(fit.coefficients[1], -3, 1e-10);
  EXPECT_NEAR(fit.coefficients[2], 0.5, 1e-10);
  double leverage = 0;
  for (std::size_t s = 0; s < 6; ++s) leverage += fit.hat[s][s];
  EXPECT_NEAR(leverage, 3, 1e-10) << "the hat matrix has trace p";
}

TEST(Scaling, AnExactPowerLawGivesItsExponentAndAPoint) {
  const ScalingEntry entry =
      fit(doubling(64, 9), 3, [](double n) { return 2 + 1.5 * std::log(n); });
  ASSERT_TRUE(entry.decided);
  EXPECT_NEAR(entry.power.exponent, 1.5, 1e-9);
  EXPECT_NEAR(entry.power.log_factor, 2, 1e-9);
  EXPECT_LT(entry.power.exponent_interval.width(), 1e-9);
  EXPECT_EQ(entry.growth, Growth::power);
}

TEST(Scaling, FewSizesAreUndecidedAndSayWhatIsMissing) {
  const ScalingEntry entry = fit(doubling(64, 7), 5, n_itself, 0.1);
  EXPECT_FALSE(entry.decided);
  EXPECT_EQ(entry.growth, Growth::undecided);
  EXPECT_TRUE(entry.power.fitted) << "the estimate is shown, without an interval";
  EXPECT_TRUE(std::isnan(entry.power.exponent_interval.low));
  EXPECT_THAT(entry.reason, HasSubstr("7 sizes"));
  EXPECT_EQ(entry.next, "size 8192 with 8 seeds each");
  EXPECT_EQ(entry.next_sizes, std::vector<std::int64_t>({8192}));
}

TEST(Scaling, WhatItAsksForDecides) {
  const auto n_squared = [](double n) { return 2 * std::log(n); };
  std::vector<std::int64_t> sizes = doubling(64, 6);
  ScalingEntry entry = fit(sizes, 4, n_squared, 0.1);
  for (int round = 0; round < 8 && entry.growth != Growth::power; ++round) {
    ASSERT_FALSE(entry.next.empty()) << entry.reason;
    sizes.insert(sizes.end(), entry.next_sizes.begin(), entry.next_sizes.end());
    entry = fit(sizes, 8, n_squared, 0.1);
  }
  EXPECT_EQ(entry.growth, Growth::power) << entry.reason << "; " << entry.next;
}

TEST(Scaling, CloseSizesAreUndecided) {
  const ScalingEntry entry = fit({100, 110, 120, 130, 140, 150, 160, 170}, 5, n_itself, 0.1);
  EXPECT_FALSE(entry.decided);
  EXPECT_THAT(entry.reason, HasSubstr("1.7 times"));
}

TEST(Scaling, SmallSizesAreLeftOutOnlyWhileEnoughStay) {
  const auto many = sizes_of(doubling(4, 12), 2, n_itself);  // 4 … 8192
  const std::vector<SizeSample> chosen = choose_sizes(many, 8);
  EXPECT_EQ(chosen.size(), 8u);
  EXPECT_EQ(chosen.front().n, 64);
  EXPECT_EQ(choose_sizes(many, 5).front().n, 128) << "the square root of 8192 is 90.5";
}

TEST(Scaling, SizesWithUnfinishedInstancesAreLeftOut) {
  Results results = good_results({"diamond"}, {"cubic"}, 9, 4);
  results.runs[33].status = RunStatus::timeout;  // size 16 * 2^8
  const ScalingEntry entry = fit_scaling(samples(tally_of(results).curves[0], Quantity::wall_s));
  EXPECT_EQ(entry.all.size(), 9u);
  EXPECT_EQ(entry.used.back().n, 16 << 7);
  const std::vector<DrawnGraph> censored = tally_of(results).curves[0].censored;
  ASSERT_EQ(censored.size(), 1u);
  EXPECT_EQ(censored[0].row, 33u);
  EXPECT_EQ(censored[0].n, 16 << 8);
  for (const ScalingEntry& of_study : scaling(results)) EXPECT_EQ(of_study.censored, 1u);
}

TEST(Scaling, MissingAndZeroValuesAreNoPoints) {
  auto run = good_run("diamond", "path", 16, 0);
  run.extents = {0, 12, -1};
  run.wall_s = kMissing;
  run.log2_volume = kMissing;
  run.counters = "a_skew_x=3;skew_x=7;skew_y=;skew_z=99999999999999999999";
  Results results;
  results.runs = {run};
  const StudyTally tally = tally_of(results);
  const DrawnGraph& graph = tally.curves.at(0).sizes.at(16).graphs.at(0);
  const auto log_of = [&](Quantity quantity) { return log_value(graph, quantity, false); };
  EXPECT_TRUE(std::isnan(log_of(Quantity::extent_x)));
  EXPECT_DOUBLE_EQ(log_of(Quantity::extent_y), std::log(12));
  EXPECT_TRUE(std::isnan(log_of(Quantity::extent_z)));
  EXPECT_DOUBLE_EQ(log_of(Quantity::longest_side), std::log(12));
  EXPECT_TRUE(std::isnan(log_of(Quantity::wall_s)));
  EXPECT_TRUE(std::isnan(log_of(Quantity::volume)));
  EXPECT_DOUBLE_EQ(log_of(Quantity::skewed_x), std::log(7));
  EXPECT_TRUE(std::isnan(log_of(Quantity::skewed_y)));
  EXPECT_TRUE(std::isnan(log_of(Quantity::skewed_z)));
}

TEST(Scaling, RepetitionsOfAnInstanceGiveTheirMedian) {
  Results results;
  for (const double wall_s : {1.0, 100.0, 2.0}) {
    results.runs.push_back(
        good_run("diamond", "cubic", 16, 0, static_cast<std::int64_t>(results.runs.size())));
    results.runs.back().wall_s = wall_s;
  }
  const auto sizes = samples(tally_of(results).curves[0], Quantity::wall_s);
  ASSERT_EQ(sizes.size(), 1u);
  ASSERT_EQ(sizes[0].instances.size(), 1u);
  EXPECT_DOUBLE_EQ(sizes[0].instances[0].first, std::log(2));
}

TEST(Scaling, RowsOfTheTimingPhaseAloneSpeakForTime) {
  Results results;
  for (const double wall_s : {1.0, 100.0, 7.0, 3.0}) {
    results.runs.push_back(good_run("diamond", "cubic", 16, 0, 0));
    results.runs.back().wall_s = wall_s;
  }
  results.runs[1].phase = RunPhase::strong;
  results.runs[2].phase = RunPhase::timing;
  results.runs[3].instance_index = 1;  // a graph that was never timed alone
  const auto time = [&] { return samples(tally_of(results).curves[0], Quantity::wall_s)[0]; };
  ASSERT_EQ(time().instances.size(), 1u) << "phases are not mixed within a cell";
  EXPECT_DOUBLE_EQ(time().instances[0].first, std::log(7));
  results.runs[2].status = RunStatus::timeout;
  ASSERT_EQ(time().instances.size(), 2u) << "no timing row left: the metrics rows, for plots";
}

TEST(Scaling, TimesOfTheMetricsPhaseHaveNoExponent) {
  Results results = good_results({"grid"}, {"cubic"}, 9, 8);
  const auto time = [&] { return scaling(results).back(); };
  EXPECT_EQ(time().quantity, Quantity::wall_s);
  EXPECT_EQ(time().growth, Growth::undecided);
  EXPECT_FALSE(time().power.fitted);
  EXPECT_EQ(time().reason, "no rows of the timing phase");
  for (auto& run : results.runs) run.phase = RunPhase::timing;
  EXPECT_TRUE(time().decided);
}

TEST(Scaling, OfAStudyFindsTheExponentOfEveryQuantity) {
  Results results = good_results({"diamond", "grid"}, {"cubic"}, 9, 8);
  for (auto& run : results.runs) {
    run.phase = RunPhase::timing;
    if (run.algorithm == "grid") run.counters = fmt::format("skew_y={};H=0", run.n);
  }
  const std::vector<ScalingEntry> entries = scaling(results);
  ASSERT_EQ(entries.size(), 13u);
  for (const ScalingEntry& entry : entries) {
    const double truth = entry.quantity == Quantity::volume ? 3 : 1;
    EXPECT_NEAR(entry.power.exponent, truth, 0.05) << name_of(entry.quantity);
    EXPECT_TRUE(entry.decided);
  }
  const std::vector<ScalingEntry> again = scaling(results);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    EXPECT_EQ(entries[i].power.exponent_interval.low, again[i].power.exponent_interval.low);
  }
}

TEST(Scaling, SizesOffTheLineWidenTheInterval) {
  const auto zigzag = [](double n) {
    return std::log(n) + (std::lround(std::log2(n)) % 2 == 0 ? 0.2 : -0.2);
  };
  const ScalingEntry entry = fit(doubling(64, 10), 8, zigzag, 0.001);
  EXPECT_TRUE(entry.power.exponent_interval.contains(1));
  EXPECT_GT(entry.power.exponent_interval.width(), 0.05);
}

TEST(Scaling, AStrongLogarithmIsFoundAndNoneIsRuledOut) {
  const auto n_log2_n = [](double n) { return std::log(n) + 2 * std::log(std::log(n)); };
  const auto n_squared = [](double n) { return 2 * std::log(n); };
  const ScalingEntry with = fit(doubling(64, 12), 20, n_log2_n, 0.01);
  EXPECT_EQ(with.growth, Growth::power_and_log) << with.reason;
  EXPECT_TRUE(with.with_log.log_exponent_interval.contains(2)) << with.reason;
  const ScalingEntry without = fit(doubling(64, 12), 20, n_squared, 0.01);
  EXPECT_EQ(without.growth, Growth::power) << without.reason;
  EXPECT_TRUE(without.law_interval.contains(2));
}

/// A theorem bounds this quantity by c n: a line that rises faster is true of its sizes only.
TEST(Scaling, ALawAboveTheOrderOfATheoremIsApparent) {
  const auto n_12 = [](double n) { return 1.2 * std::log(n); };
  const SizeBound theorem{"here", "a page", {linear(8), sqrt_n(3), quadratic(1)}};
  const ScalingEntry law = fit(doubling(64, 12), 20, n_12, 0.001);
  ASSERT_EQ(law.growth, Growth::power) << law.reason;
  ScalingEntry below = law;
  refuse_law_above(theorem_order(theorem, Quantity::extent_z).value(), below);
  EXPECT_EQ(below.growth, Growth::power);
  ScalingEntry above = law;
  refuse_law_above(theorem_order(theorem, Quantity::extent_x).value(), above);
  EXPECT_EQ(above.growth, Growth::apparent);
  EXPECT_THAT(above.reason, HasSubstr("above the order n^1 of the theorem's bound"));
  EXPECT_EQ(theorem_order(theorem, Quantity::extent_y), 0.5);
  EXPECT_EQ(theorem_order(theorem, Quantity::volume), 3.5);
  EXPECT_EQ(theorem_order(theorem, Quantity::longest_side), 2);
  EXPECT_FALSE(theorem_order(theorem, Quantity::wall_s));
  EXPECT_FALSE(theorem_order(SizeBound(), Quantity::volume));
}

/// The local exponent rises at a cache boundary; logarithms of exponent -3 to -25 were seen in it.
TEST(Scaling, ACacheBoundaryIsNoLogarithm) {
  const auto stepped = [](double n) { return std::log(n) + 1 / (1 + std::exp(-(n - 4e4) / 8e3)); };
  const ScalingEntry entry = fit(doubling(464, 9), 8, stepped, 0.01);
  EXPECT_EQ(entry.growth, Growth::apparent) << entry.reason;
  EXPECT_THAT(entry.reason, HasSubstr("rises"));
}

/// Volumes of boxes (an + b)^3 were once called n^3.02 log^0.61 n.
TEST(Scaling, ALogarithmsExponentIsAWholeNumber) {
  const auto truth = [](double n) { return 3 * std::log(n) + 0.6 * std::log(std::log(n)); };
  const ScalingEntry entry = fit(doubling(64, 12), 8, truth, 0.002);
  EXPECT_FALSE(entry.with_log.log_exponent_interval.contains(1));
  EXPECT_EQ(entry.growth, Growth::apparent) << entry.reason;
}

/// The apparent exponent of n + 4 sqrt(n) is below 1, which is the exponent.
TEST(Scaling, ALowerOrderTermIsNoExponent) {
  const ScalingEntry entry =
      fit(doubling(64, 8), 8, [](double n) { return std::log(n + 4 * std::sqrt(n)); });
  EXPECT_LT(entry.power.exponent, 0.95);
  EXPECT_EQ(entry.growth, Growth::apparent) << entry.reason;
}

}  // namespace
}  // namespace ar3d::testing
