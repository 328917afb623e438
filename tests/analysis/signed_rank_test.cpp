// The test behind every verdict on times, against brute force and published tables.
#include <cmath>

#include "ar3d/analysis/compare/time_change.h"
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
  const SignedRankTest test = signed_rank_test(values, distribution, 0.95);
  const SignedRankTest other = signed_rank_test(moved, distribution, 0.95);
  EXPECT_NEAR(other.estimate, test.estimate + 2, 1e-12);
  EXPECT_NEAR(other.interval.low, test.interval.low + 2, 1e-12);
  EXPECT_NEAR(other.interval.high, test.interval.high + 2, 1e-12);
  EXPECT_TRUE(test.interval.contains(test.estimate));
  EXPECT_DOUBLE_EQ(other.p_greater, std::ldexp(1.0, -8));  // all positive
  EXPECT_DOUBLE_EQ(other.p_value(), std::ldexp(1.0, -7));
}

TEST(SignedRank, ZerosAndTiesNeverHelp) {
  const std::vector<double> zeros(20, 0.0);
  const SignedRankTest test = signed_rank_test(zeros, SignedRankDistribution(20), 0.95);
  EXPECT_EQ(test.p_value(), 1);
  EXPECT_EQ(test.estimate, 0);
  const SignedRankTest none = signed_rank_test({}, SignedRankDistribution(0), 0.95);
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

}  // namespace
}  // namespace ar3d::testing
