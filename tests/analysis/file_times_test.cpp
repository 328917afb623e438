// Files of a simulated machine: how often their comparison is wrong, and what it finds.
#include "ar3d/analysis/compare/file_times.h"

#include <cmath>

#include "ar3d/analysis/compare/compare.h"
#include "synthetic.h"

namespace ar3d::testing {
namespace {

constexpr std::size_t kRounds = 12;
constexpr const char* kAlgorithms[] = {"diamond", "grid", "two-bend"};
constexpr const char* kSlowed = "grid";

/// How the machine was while a file was made: at how many of its rounds other processes slowed it.
enum class Machine { quiet, disturbed, slow };

/// 3 algorithms x 8 families x 3 graphs, in rounds. A time is its true value times exp(|1 %
/// normal|) noise, one in ten hit by a burst (1 + a Pareto number from 0.1); a cell has its place
/// in memory (normal 0.5 %). Of spells one half slow the clock, and all that runs by it, by one
/// factor of 1 to 1.1. The others are neighbours in the caches: a factor of 1.1 to 1.3 for all but
/// arithmetic, which an algorithm and the yardsticks feel differently (normal 1 %), and a cell too
/// (normal 1.5 %).
Results file_of(Machine machine, std::uint64_t number, double slowdown) {
  RandomStream random(31, number);
  Results results;
  results.study_id = "simulated";
  std::array<std::array<double, kRounds>, 4> state{};  // of the algorithms and the yardsticks
  std::array<double, kRounds> clock{};
  for (std::size_t round = 0; round < kRounds;) {
    const bool is_slow =
        machine == Machine::slow || (machine == Machine::disturbed && random.chance(1, 2));
    const bool is_clock = is_slow && random.chance(1, 2);
    const double factor = std::log((is_clock ? 1 : 1.1) + (is_clock ? 0.1 : 0.2) * random.unit());
    const std::size_t end = machine == Machine::slow ? kRounds : round + 1 + random.below(6);
    std::array<double, 4> felt{};
    for (double& of : felt) of = is_slow && !is_clock ? factor + 0.01 * normal(random) : 0;
    for (; round < std::min(end, kRounds); ++round) {
      for (std::size_t of = 0; of < 4; ++of) state[of][round] = felt[of];
      clock[round] = is_clock ? factor : 0;
    }
  }
  for (std::size_t algorithm = 0; algorithm < 3; ++algorithm) {
    const double planted =
        kAlgorithms[algorithm] == std::string(kSlowed) ? std::log1p(slowdown) : 0;
    for (int family = 0; family < 8; ++family) {
      const double placed = 0.005 * normal(random), feeling = 0.015 * normal(random);
      for (std::int64_t graph = 0; graph < 3; ++graph) {
        RunRecord row =
            good_run(kAlgorithms[algorithm], "family" + std::to_string(family), 300, graph);
        row.phase = RunPhase::timing;
        const double true_s = row.wall_s;
        for (std::size_t round = 0; round < kRounds; ++round) {
          row.repetition = static_cast<std::int64_t>(round);
          const double burst = random.chance(1, 10) ? std::log1p(0.1 / (1 - random.unit())) : 0;
          const double slowness = state[algorithm][round];
          const double felt = slowness > 0 ? slowness + feeling : 0;
          row.cpu_s = true_s * std::exp(planted + placed + felt + clock[round] + burst +
                                        std::abs(0.01 * normal(random)));
          for (std::size_t i = 0; i < row.yardsticks_s.size(); ++i) {
            row.yardsticks_s[i] = std::exp((i < 2 ? state[3][round] : 0) + clock[round] +
                                           std::abs(0.02 * normal(random)));
          }
          results.runs.push_back(row);
        }
      }
    }
  }
  return results;
}

struct Rates {
  std::size_t pairs = 0;
  std::size_t found = 0;   ///< REGRESSED, and no other algorithm is
  std::size_t passed = 0;  ///< cells of the slowed algorithm
  std::size_t alarms = 0;  ///< cells REGRESSED or IMPROVED that nothing was done to
  std::size_t cells = 0;   ///< that pass
};

/// Pairs of files of these machines, the second with the slowdown in one algorithm.
Rates rates_of(Machine before, Machine after, double slowdown) {
  constexpr std::uint64_t kPairs = 100;
  Rates rates;
  for (std::uint64_t pair = 0; pair < kPairs; ++pair) {
    const Comparison comparison =
        compare(file_of(before, 2 * pair, 0), file_of(after, 2 * pair + 1, slowdown));
    ++rates.pairs;
    std::size_t right = 0, wrong = 0;
    for (const CellComparison& cell : comparison.cells) {
      const bool is_slowed = slowdown > 0 && cell.key.algorithm == kSlowed;
      const bool is_regressed = cell.verdict == Verdict::regressed;
      right += is_slowed && is_regressed;
      wrong += cell.verdict == Verdict::improved || (!is_slowed && is_regressed);
      rates.passed += is_slowed && cell.verdict == Verdict::pass;
      rates.cells += cell.verdict == Verdict::pass;
    }
    rates.found += right > 0 && wrong == 0;
    rates.alarms += wrong;
  }
  return rates;
}

constexpr Machine kMachines[] = {Machine::quiet, Machine::disturbed, Machine::slow};

TEST(FileTimes, NothingIsFoundWhereNothingChangedWhateverTheMachine) {
  for (const Machine before : kMachines) {
    for (const Machine after : kMachines) {
      const Rates rates = rates_of(before, after, 0);
      const int which = 3 * static_cast<int>(before) + static_cast<int>(after);
      std::printf("machines %d: %zu of 2400 cells pass\n", which, rates.cells);
      EXPECT_EQ(rates.alarms, 0U) << which;
      if (before == Machine::quiet && after == Machine::quiet) {
        EXPECT_GE(rates.cells, 2160U);  // 90 %
      }
    }
  }
}

TEST(FileTimes, ASlowedAlgorithmIsFoundOnAQuietMachineAndPassesNowhere) {
  for (const double slowdown : {0.03, 0.05, 0.10, 0.20}) {
    for (const Machine after : kMachines) {
      const Rates rates = rates_of(Machine::quiet, after, slowdown);
      std::printf("%2.0f %% slower, machine %d: found in %zu of %zu pairs, %zu cells pass\n",
                  100 * slowdown, static_cast<int>(after), rates.found, rates.pairs, rates.passed);
      EXPECT_EQ(rates.alarms, 0U) << slowdown;
      if (slowdown >= 0.1) {
        EXPECT_EQ(rates.passed, 0U) << slowdown;
      }
      if (after != Machine::quiet) continue;
      if (slowdown >= 0.05) {
        EXPECT_GE(rates.found, slowdown >= 0.1 ? 99U : 90U) << slowdown;
      }
    }
  }
}

// A clock that was wrong in a single round: 22 microseconds among 60 rounds of 28 and more.
TEST(FileTimes, OneRoundMovesNoCell) {
  const auto change = [](double spread) {
    std::vector<CellTimes> cells;
    for (int i = 0; i < 24; ++i)
      cells.push_back({"s" + std::to_string(i % 3), 60, 0, 0.002, {}, 3});
    cells[4].ratio = -0.22;
    cells[4].spread = spread;
    return judge_file_times(cells, {}, {}).cells[4];
  };
  EXPECT_EQ(change(0.15), Verdict::inconclusive);
  EXPECT_EQ(change(0.02), Verdict::improved);
}

TEST(FileTimes, FewerThanThreeSettingsNeedMore) {
  const auto change = [](double ratio, std::size_t settings) {
    std::vector<CellTimes> cells;
    for (std::size_t i = 0; i < 8 * settings; ++i) {
      cells.push_back({"setting" + std::to_string(i % settings),
                       12,
                       i % settings == 0 ? ratio : 0,
                       0.002,
                       {0, 0}});
    }
    return judge_file_times(cells, {}, {}).cells.front();
  };
  EXPECT_EQ(change(std::log(1.05), 3), Verdict::regressed);
  EXPECT_EQ(change(std::log(1.05), 1), Verdict::inconclusive);
  EXPECT_EQ(change(std::log(1.10), 1), Verdict::regressed);
  EXPECT_EQ(change(-std::log(1.10), 2), Verdict::improved);
  EXPECT_EQ(change(std::log(1.02), 1), Verdict::pass);
}

}  // namespace
}  // namespace ar3d::testing
