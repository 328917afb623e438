// Synthetic truth: how often the 95 % interval holds the true exponent, and how often a growth
// label is wrong.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/synthetic.h"
#include "ar3d/analysis/scaling.h"

namespace ar3d {
namespace {

using testing::doubling;
using testing::normal;
using Noise = double (*)(RandomStream&, double);

constexpr int kTrials = 2000;

double even(RandomStream& random, double) { return 0.1 * normal(random); }
/// Times of small graphs scatter more than those of large ones.
double uneven(RandomStream& random, double n) { return (0.02 + 2 / std::sqrt(n)) * normal(random); }
/// A few slow ones: exponential, mean 0.
double skewed(RandomStream& random, double) { return 0.1 * (-std::log(1 - random.unit()) - 1); }

struct Case {
  const char* name;
  std::size_t sizes;
  std::size_t instances;
  Noise noise;
};

class Coverage : public ::testing::TestWithParam<Case> {};

TEST_P(Coverage, OfThe95PercentIntervalIsBetween93And97Percent) {
  FitOptions options;
  options.bootstrap.replicates = 600;
  const auto truth = [](double n) { return 1 + 1.25 * std::log(n); };
  const auto sizes = doubling(64, GetParam().sizes);
  int covered = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    RandomStream random(77, static_cast<std::uint64_t>(trial));
    const auto samples =
        testing::noisy_samples(sizes, GetParam().instances, random, truth, GetParam().noise);
    BootstrapOptions bootstrap = options.bootstrap;
    bootstrap.seed = static_cast<std::uint64_t>(trial);
    covered += fit_curve(samples, false, true, bootstrap).exponent_interval.contains(1.25);
  }
  const double share = static_cast<double>(covered) / kTrials;
  RecordProperty("coverage", std::to_string(share));
  std::printf("coverage %s: %.4f\n", GetParam().name, share);
  EXPECT_GE(share, 0.93);
  EXPECT_LE(share, 0.97);
}

INSTANTIATE_TEST_SUITE_P(
    Noise, Coverage,
    ::testing::Values(Case{"even_8x8", 8, 8, even}, Case{"even_8x3", 8, 3, even},
                      Case{"even_12x2", 12, 2, even}, Case{"even_8x1", 8, 1, even},
                      Case{"uneven_10x8", 10, 8, uneven}, Case{"skewed_8x8", 8, 8, skewed}),
    [](const auto& info) { return std::string(info.param.name); });

/// Counts of labels over many trials of one truth.
struct Labels {
  int power = 0;
  int power_and_log = 0;
};

Labels label(double a, double b, std::size_t sizes, std::size_t instances, int trials = 400) {
  FitOptions options;
  options.bootstrap.replicates = 400;
  const auto truth = [=](double n) { return a * std::log(n) + b * std::log(std::log(n)); };
  int power = 0, power_and_log = 0;
  for (int trial = 0; trial < trials; ++trial) {
    RandomStream random(78, static_cast<std::uint64_t>(trial));
    const ScalingEntry entry = fit_scaling(
        testing::noisy_samples(doubling(64, sizes), instances, random, truth, even), options);
    power += entry.growth == Growth::power;
    power_and_log += entry.growth == Growth::power_and_log;
  }
  std::printf("n^%g log^%g n, %zu sizes x %zu: power %d, with log %d of %d\n", a, b, sizes,
              instances, power, power_and_log, trials);
  return {power, power_and_log};
}

TEST(Labels, AreWrongInAtMostOnePercentAtTenPercentNoise) {
  EXPECT_LE(label(1, 0, 11, 8).power_and_log, 4);
  EXPECT_LE(label(1, 1, 11, 8).power, 4);
  EXPECT_LE(label(2, 0, 12, 40).power_and_log, 4);
  EXPECT_LE(label(1, 2, 12, 40).power, 4);
}

TEST(Labels, AreGivenWhereTheModelsAreDistinguishable) {
  EXPECT_GE(label(1, 2, 14, 200, 50).power_and_log, 45);
  EXPECT_GE(label(1, 0, 14, 400, 50).power, 45);
}

}  // namespace
}  // namespace ar3d
