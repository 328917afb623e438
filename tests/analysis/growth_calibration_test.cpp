// Growth labels on simulated truth. results/reference/rates.md quotes some of what this test prints:
//   build/release/tests/ar3d_analysis_tests --gtest_filter='GrowthCalibration.*'
#include <cmath>
#include <cstdio>
#include <functional>

#include "ar3d/analysis/scaling/scaling.h"
#include "synthetic.h"

namespace ar3d::testing {
namespace {

/// How a value comes about: log value = truth(n) + one error for the whole size + one per graph.
struct Scenario {
  const char* name;
  double exponent;                      ///< the limit of the local exponent
  double log_exponent = 0;              ///< of a logarithm in the truth
  std::function<double(double)> truth;  ///< of n
  std::function<double(RandomStream&, double)> graph_noise;
  double size_noise = 0;      ///< standard deviation of the common error of a size
  double finished_share = 1;  ///< of the graphs of the two largest sizes
  bool has_exponent = true;   ///< false: the truth is no power law over these sizes
};

double power(double n) { return 1.25 * std::log(n); }
double none(RandomStream&, double) { return 0; }
double one_percent(RandomStream& random, double) { return 0.01 * normal(random); }
double ten_percent(RandomStream& random, double) { return 0.1 * normal(random); }
double falling(RandomStream& random, double n) {
  return (0.02 + 2 / std::sqrt(n)) * normal(random);
}
double skewed(RandomStream& random, double) { return 0.1 * (-std::log(1 - random.unit()) - 1); }
/// Student's t with two degrees of freedom: no variance.
double heavy_tails(RandomStream& random, double) {
  const double chi = -2 * std::log(1 - random.unit());
  return 0.05 * normal(random) / std::sqrt(chi / 2);
}
double outliers(RandomStream& random, double) {
  return 0.05 * normal(random) + (random.chance(1, 20) ? std::log(10) : 0);
}
double two_families(RandomStream& random, double) {
  return 0.05 * normal(random) + (random.chance(1, 2) ? std::log(2) : 0);
}
double two_exponents(RandomStream& random, double n) {
  return 0.05 * normal(random) + (random.chance(1, 2) ? 0.1 : -0.1) * std::log(n);
}
double cache_step(double n, double at, double factor) {
  return std::log(factor) / (1 + std::exp(-2 * (std::log2(n / at))));
}

std::vector<Scenario> scenarios() {
  const auto log_of = [](auto f) { return [f](double n) { return std::log(f(n)); }; };
  return {
      {"n^1.25, graphs 10 %", 1.25, 0, power, ten_percent},
      {"n^1.25, graphs 1 %", 1.25, 0, power, one_percent},
      {"n^1.25, noise falls with n", 1.25, 0, power, falling},
      {"n^1.25, skewed", 1.25, 0, power, skewed},
      {"n^1.25, sizes 2 %, graphs 10 %", 1.25, 0, power, ten_percent, 0.02},
      {"n^1.25, sizes 5 %, graphs 10 %", 1.25, 0, power, ten_percent, 0.05},
      {"n^1.25, sizes 5 %, graphs 1 %", 1.25, 0, power, one_percent, 0.05},
      {"n^1.25, heavy tails (t, 2 df)", 1.25, 0, power, heavy_tails},
      {"n^1.25, 5 % outliers, ten-fold", 1.25, 0, power, outliers},
      {"n^1.25, two families, factor 2", 1.25, 0, power, two_families},
      {"n^1.25±0.1, two families", 1.25, 0, power, two_exponents},
      {"n^1.25, unfinished rows", 1.25, 0, power, ten_percent, 0, 0.5},
      {"n + 4 √n, 1 %", 1, 0, log_of([](double n) { return n + 4 * std::sqrt(n); }), one_percent},
      {"n + 4 √n, 10 %", 1, 0, log_of([](double n) { return n + 4 * std::sqrt(n); }), ten_percent},
      {"n + 100, 1 %", 1, 0, log_of([](double n) { return n + 100; }), one_percent},
      {"n + 100, 10 %", 1, 0, log_of([](double n) { return n + 100; }), ten_percent},
      {"n − 2 √n, 1 %", 1, 0, log_of([](double n) { return n - 2 * std::sqrt(n); }), one_percent},
      {"n² + 50 n, 1 %", 2, 0, log_of([](double n) { return n * n + 50 * n; }), one_percent},
      {"4n − 4, rounded up", 1, 0, log_of([](double n) { return 4 * n - 4; }), none},
      {"n, step ×2 in the middle, 1 %", 1, 0,
       [](double n) { return std::log(n) + cache_step(n, 1500, 2); }, one_percent},
      {"n, step ×1.5 early, 1 %", 1, 0,
       [](double n) { return std::log(n) + cache_step(n, 200, 1.5); }, one_percent},
      {"n, step ×1.5 late, 5 %", 1, 0,
       [](double n) { return std::log(n) + cache_step(n, 12000, 1.5); }, one_percent, 0.05},
      {"n, steps ×1.3 and ×2, sizes 2 %", 1, 0,
       [](double n) { return std::log(n) + cache_step(n, 250, 1.3) + cache_step(n, 4000, 2); },
       one_percent, 0.02},
      {"n log n, 1 %", 1, 1, [](double n) { return std::log(n) + std::log(std::log(n)); },
       one_percent},
      {"n log n, 10 %", 1, 1, [](double n) { return std::log(n) + std::log(std::log(n)); },
       ten_percent},
      {"n log² n, 1 %", 1, 2, [](double n) { return std::log(n) + 2 * std::log(std::log(n)); },
       one_percent},
      {"n log² n, 10 %", 1, 2, [](double n) { return std::log(n) + 2 * std::log(std::log(n)); },
       ten_percent},
  };
}

std::vector<SizeSample> simulated(const Scenario& scenario, std::size_t sizes, std::size_t graphs,
                                  RandomStream& random) {
  std::vector<SizeSample> samples;
  for (std::size_t s = 0; s < sizes; ++s) {
    SizeSample size;
    size.n = std::int64_t{64} << s;
    const auto n = static_cast<double>(size.n);
    const double common = scenario.size_noise * normal(random);
    for (std::size_t i = 0; i < graphs; ++i) {
      const double value = scenario.truth(n) + common + scenario.graph_noise(random, n);
      const bool is_large = s + 2 >= sizes;
      if (is_large && random.unit() > scenario.finished_share) {
        size.censored = true;
      } else {
        size.instances.push_back({value, i});
      }
    }
    if (!size.instances.empty()) samples.push_back(std::move(size));
  }
  return samples;
}

/// Slope of the least-squares line through the truth at the fitted sizes: what the apparent
/// exponent estimates.
double projected_exponent(const Scenario& scenario, const std::vector<SizeSample>& used) {
  std::vector<SizeSample> exact;
  for (const SizeSample& size : used) {
    exact.push_back({.n = size.n, .instances = {{scenario.truth(static_cast<double>(size.n)), 0}}});
  }
  return fit_curve(exact, false, false).exponent;
}

struct Score {
  int trials = 0, covered = 0, power = 0, with_log = 0, apparent = 0, undecided = 0, wrong = 0;
  double width = 0;
};

/// A label is wrong if it says a power law and the limit of the local exponent is outside of the
/// stated interval or there is a logarithm; or a logarithm where there is none, or whose exponent
/// is outside of its interval.
bool is_wrong(const Scenario& scenario, const ScalingEntry& entry) {
  if (entry.growth == Growth::power) {
    return scenario.log_exponent != 0 || !entry.law_interval.contains(scenario.exponent);
  }
  if (entry.growth != Growth::power_and_log) return false;
  return scenario.log_exponent == 0 ||
         !entry.with_log.log_exponent_interval.contains(scenario.log_exponent);
}

Score score(const Scenario& scenario, std::size_t sizes, std::size_t graphs, int trials) {
  Score score;
  score.trials = trials;
  for (int trial = 0; trial < trials; ++trial) {
    RandomStream random(177, static_cast<std::uint64_t>(trial));
    const ScalingEntry entry = fit_scaling(simulated(scenario, sizes, graphs, random));
    score.undecided += entry.growth == Growth::undecided;
    if (!entry.decided) continue;
    score.covered +=
        entry.power.exponent_interval.contains(projected_exponent(scenario, entry.used));
    score.width += entry.power.exponent_interval.width();
    score.power += entry.growth == Growth::power;
    score.with_log += entry.growth == Growth::power_and_log;
    score.apparent += entry.growth == Growth::apparent;
    score.wrong += is_wrong(scenario, entry);
  }
  return score;
}

void expect_honest(std::size_t sizes, std::size_t graphs) {
  constexpr int kTrials = 1000;
  std::printf(
      "\n| %zu sizes x %zu graphs | coverage | width | power law | with log | apparent | "
      "undecided | wrong |\n|---|---|---|---|---|---|---|---|\n",
      sizes, graphs);
  for (const Scenario& scenario : scenarios()) {
    const Score result = score(scenario, sizes, graphs, kTrials);
    const int decided = kTrials - result.undecided;
    const auto percent = [&](int count, int of) { return of == 0 ? 0 : 100.0 * count / of; };
    std::printf("| %s | %.1f %% | %.3f | %.1f %% | %.1f %% | %.1f %% | %.1f %% | %.2f %% |\n",
                scenario.name, percent(result.covered, decided),
                decided == 0 ? 0 : result.width / decided, percent(result.power, kTrials),
                percent(result.with_log, kTrials), percent(result.apparent, kTrials),
                percent(result.undecided, kTrials), percent(result.wrong, kTrials));
    const double least = graphs == 1 ? 88 : 93;  // two families of one graph: normal no more
    if (decided > 0) {
      EXPECT_GE(percent(result.covered, decided), least) << scenario.name;
    }
    EXPECT_LE(percent(result.wrong, kTrials), 5) << scenario.name;
  }
}

TEST(GrowthCalibration, EightSizesOfEightGraphs) { expect_honest(8, 8); }
TEST(GrowthCalibration, ElevenSizesOfEightGraphs) { expect_honest(11, 8); }
TEST(GrowthCalibration, TenSizesOfOneGraph) { expect_honest(10, 1); }

}  // namespace
}  // namespace ar3d::testing
