// The phases after the metrics: timing, strong and weak scaling.
#include <atomic>
#include <cmath>
#include <csignal>
#include <map>
#include <set>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/run/execute.h"
#include "ar3d/store/columns/run_columns.h"
#include "bench/in_memory.h"
#include "bench/seeded.h"

namespace ar3d::testing {
namespace {

SessionPolicy forced() {
  SessionPolicy policy;
  policy.force_timing = true;  // these tests run in sanitised builds too
  return policy;
}

StudyPlan study(const std::string& sweep) {
  return plan_study(parse_study("study = \"t\"\n[[sweep]]\nfamilies = \"cycle\"\n" + sweep, "t"));
}

TEST(MetricsPhase, MakesOnlyWhatIsWantedAndStops) {
  const StudyPlan sizes = study("sizes = [5, 6, 7, 8]\nalgorithms = [\"diamond\"]\n");
  const RunRecord there = make(sizes, forced()).rows.at(1);
  const Made others = make(sizes, forced(), {{there.row_key, there}});
  EXPECT_THAT(others.order, ::testing::UnorderedElementsAre(0, 2, 3));
  const StudyPlan plan = plan_of(cycle_of(5, {&find_algorithm("diamond")}, 4));
  const Interruptible interruptible;
  EXPECT_THAT(make(plan, forced(), {}, [] { std::raise(SIGINT); }).order, ElementsAre(0));
}

TEST(TimingPhase, GoesRoundAllDrawingsPinnedAndAlone) {
  const StudyPlan plan =
      study("sizes = [10, 20]\nalgorithms = [\"diamond\", \"grid\"]\ntimed_repetitions = 3\n");
  ASSERT_EQ(plan.rows(), 4u * (1 + 3));
  SessionPolicy policy = forced();
  policy.workers = 2;
  const Made made = make(plan, policy);
  ASSERT_EQ(made.rows.size(), plan.rows());
  std::vector<std::int64_t> repetitions;  // of the timing rows, as they were made
  for (const std::size_t row : made.order) {
    const RunRecord& run = made.rows.at(row);
    EXPECT_EQ(run.status, RunStatus::ok) << run.message;
    if (run.phase == RunPhase::metrics) {
      EXPECT_TRUE(repetitions.empty()) << "the metrics come first";
      EXPECT_EQ(run.concurrency, 2);
      EXPECT_EQ(run.core, -1);
      continue;
    }
    repetitions.push_back(run.repetition);
    EXPECT_EQ(run.concurrency, 1);
    EXPECT_EQ(run.core, allowed_cores().back());
    EXPECT_EQ(run.warm_ups, 1);
    EXPECT_EQ(run.build_kind, build_kind());
    EXPECT_EQ(run.peak_scope, "row");
    EXPECT_EQ(std::isnan(run.certify_s), run.repetition > 0) << "the first one is certified";
    EXPECT_EQ(run.violations, 0);
    for (const double yardstick_s : run.yardsticks_s) EXPECT_GT(yardstick_s, 0);
  }
  EXPECT_THAT(repetitions, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2));
  ASSERT_EQ(made.notes.size(), 3u);
  EXPECT_EQ(made.notes[0].name, kTimingRounds);
  EXPECT_THAT(made.notes[0].value, StartsWith("3 rounds, as many as the study makes: "));
  EXPECT_EQ(made.notes[1].name, kTimingYardsticks);
  EXPECT_GT(std::stod(made.notes[1].value), 0);
  EXPECT_EQ(made.notes[2].name, kTimingOrder);
}

TEST(TimingPhase, RowsHaveKeysOfTheirOwnAndReplaySpecIsKept) {
  const StudyPlan without = study("sizes = 10\nalgorithms = \"diamond\"\n");
  const StudyPlan with = study("sizes = 10\nalgorithms = \"diamond\"\ntimed_repetitions = 2\n");
  const auto& runs = with.instances[0].runs;
  EXPECT_EQ(runs[0].row_key, without.instances[0].runs[0].row_key)
      << "timing changes no key of the metrics";
  std::set<std::string> keys;
  for (const PlannedRun& run : runs) keys.insert(run.row_key);
  EXPECT_EQ(keys.size(), 3u);
}

TEST(TimingPhase, OptionalRepetitionsEndAtThePrecision) {
  const StudyPlan plan = study(
      "sizes = 10\nalgorithms = \"diamond\"\n"
      "timed_repetitions = { precision = 1.0, min = 6, max = 400 }\n");
  ASSERT_EQ(plan.rows(), 401u);
  EXPECT_FALSE(plan.instances[0].runs[6].optional);
  EXPECT_TRUE(plan.instances[0].runs[7].optional);
  const Made made = make(plan, forced());
  EXPECT_GE(made.rows.size(), 1u + 6);
  std::vector<double> times;
  for (const auto& [row, run] : made.rows) {
    if (run.phase == RunPhase::timing) times.push_back(log_corrected_time(run));
  }
  const bool is_enough = made.rows.size() < plan.rows();
  EXPECT_TRUE(!is_enough || halves_difference(times) <= 1.0);
  EXPECT_THAT(made.notes.at(0).value,
              is_enough ? HasSubstr("rounds, enough for the precision: 1 of 1 drawings are stable")
                        : HasSubstr("400 rounds, as many as the study makes"));

  // A second go that knows those rows needs no more.
  std::unordered_map<std::string, RunRecord> finished;
  for (const auto& [row, run] : made.rows) finished[run.row_key] = run;
  EXPECT_TRUE(make(plan, forced(), finished).rows.empty());
}

// An algorithm that draws differently the second time: its row must not pass for certified.
TEST(TimingPhase, ADrawingThatIsNotRepeatableIsACrash) {
  static int drawings = 0;
  const Algorithm fickle = diamond_drawn_by([](const Graph& graph, const Settings& options) {
    const Graph& drawn = graph;
    Settings other = options;
    if (drawings++ % 2 == 1) other[0].value = other[0].value == 0 ? 2 : 0;
    return find_algorithm("diamond").draw(drawn, other);
  });
  PlannedInstance instance = cycle_of(6000, {&fickle}, 2, RunPhase::timing);
  StudyPlan plan = plan_of(instance);
  plan.timing.warm_up = 0;
  drawings = 0;
  const Made made = make(plan, forced());
  EXPECT_EQ(made.rows.at(0).status, RunStatus::ok);
  EXPECT_EQ(made.rows.at(1).status, RunStatus::crashed);
  EXPECT_THAT(made.rows.at(1).message, HasSubstr("another drawing"));
}

// What failed in the metrics phase is not tried again a hundred times; its rows say why.
TEST(TimingPhase, ADrawingThatFailedIsNotTriedAgain) {
  static std::atomic<int> tried = 0;
  const Algorithm failing = diamond_drawn_by([](const Graph&, const Settings&) -> Drawing {
    ++tried;
    throw std::bad_alloc();
  });
  PlannedInstance instance = cycle_of(8, {&failing}, 1);
  for (const RunPhase phase : {RunPhase::timing, RunPhase::strong}) {
    for (PlannedRun run : cycle_of(8, {&failing}, 3, phase).runs) {
      run.row = instance.runs.size();
      run.row_key = "key" + std::to_string(run.row);
      if (phase == RunPhase::strong) run.workers = 1;
      instance.runs.push_back(run);
    }
  }
  tried = 0;
  const Made made = make(plan_of(instance), forced());
  ASSERT_EQ(made.rows.size(), 7u);
  for (const auto& [row, run] : made.rows) EXPECT_EQ(run.status, RunStatus::out_of_memory) << row;
  EXPECT_EQ(tried, 1);
}

TEST(TimingPhase, SeveralAtOnceStateIt) {
  StudyPlan plan = study("sizes = [10, 20, 30]\nalgorithms = \"diamond\"\ntimed_repetitions = 2\n");
  plan.timing.concurrency = static_cast<std::uint32_t>(allowed_cores().size());
  const Made made = make(plan, forced());
  EXPECT_EQ(made.rows.size(), plan.rows());
  for (const auto& [row, run] : made.rows) {
    if (run.phase == RunPhase::timing) {
      EXPECT_EQ(run.concurrency, plan.timing.concurrency);
    }
  }
  plan.timing.concurrency += 1;
  EXPECT_THROW(make(plan, forced()), InputError) << "one core each";
}

TEST(TimingPhase, ABadBuildIsRefusedUnlessForced) {
  const StudyPlan timed = study("sizes = 10\nalgorithms = \"diamond\"\ntimed_repetitions = 1\n");
  const StudyPlan plain = study("sizes = 10\nalgorithms = \"diamond\"\n");
  SessionPolicy policy;
  EXPECT_NO_THROW(require_possible(plain, policy));
  if (std::string(build_kind()).empty()) {
    EXPECT_NO_THROW(require_possible(timed, policy));
  } else {
    EXPECT_THROW(require_possible(timed, policy), InputError);
    policy.timed_phases = false;
    EXPECT_NO_THROW(require_possible(timed, policy));
  }
  EXPECT_NO_THROW(require_possible(timed, forced()));
}

TEST(ScalingPhase, BatchesHaveTheirIdealAndEfficiency) {
  const StudyPlan plan = study(
      "sizes = 10\nalgorithms = \"diamond\"\n"
      "strong = { threads = [1, 2], drawings = 4, repetitions = 2 }\n"
      "weak = { threads = [1, 2, 3], drawings = 2 }\n");
  ASSERT_EQ(plan.rows(), 1u + 2 * 4 * 2 + 2 * (1 + 2 + 3));
  const Made made = make(plan, forced());
  ASSERT_EQ(made.rows.size(), plan.rows());
  std::map<std::tuple<RunPhase, std::int64_t, std::int64_t>, std::set<double>> batch_times;
  for (const auto& [row, run] : made.rows) {
    EXPECT_EQ(run.status, RunStatus::ok) << run.message;
    EXPECT_EQ(run.violations, 0);
    if (run.phase == RunPhase::metrics) {
      EXPECT_EQ(run.workers, -1);
      EXPECT_TRUE(std::isnan(run.efficiency));
      continue;
    }
    EXPECT_EQ(run.concurrency, run.workers);
    EXPECT_GT(run.wall_s, 0);
    EXPECT_GE(run.batch_s, run.wall_s);
    EXPECT_DOUBLE_EQ(run.efficiency, run.ideal_batch_s / run.batch_s);
    const std::int64_t members = run.phase == RunPhase::strong ? 4 : 2 * run.workers;
    batch_times[{run.phase, run.workers, run.repetition / members}].insert(run.batch_s);
    if (run.workers == 1) {
      EXPECT_DOUBLE_EQ(run.efficiency, 1);
    }
  }
  EXPECT_EQ(batch_times.size(), 2u * 2 + 3);
  const auto only = [&](RunPhase phase, std::int64_t workers, std::int64_t batch) {
    const std::set<double>& times = batch_times.at({phase, workers, batch});
    EXPECT_EQ(times.size(), 1u) << "all rows of a batch state its time";
    return *times.begin();
  };
  for (const auto& [row, run] : made.rows) {
    if (run.phase == RunPhase::strong) {
      EXPECT_DOUBLE_EQ(run.ideal_batch_s, only(RunPhase::strong, 1, run.repetition / 4) /
                                              static_cast<double>(run.workers));
    }
    if (run.phase == RunPhase::weak) {
      EXPECT_DOUBLE_EQ(run.ideal_batch_s, only(RunPhase::weak, 1, 0));
    }
  }
}

// Alone, a process is the one rank; what it tells is what it drew.
TEST(ScalingPhase, OneRankIsAProcessAlone) {
  const StudyPlan plan = study(
      "sizes = [10, 20]\nalgorithms = \"diamond\"\n"
      "strong_ranks = { ranks = 1, drawings = 3, repetitions = 2 }\n");
  const Made made = make(plan, forced());
  ASSERT_EQ(made.rows.size(), plan.rows());
  for (const auto& [row, run] : made.rows) {
    EXPECT_EQ(run.status, RunStatus::ok) << run.message;
    EXPECT_EQ(run.violations, 0);
    if (run.phase == RunPhase::metrics) continue;
    EXPECT_EQ(run.phase, RunPhase::strong_ranks);
    EXPECT_EQ(run.concurrency, 1);
    EXPECT_EQ(run.warm_ups, 1);
    EXPECT_GE(run.batch_s, run.wall_s);
    EXPECT_DOUBLE_EQ(run.efficiency, 1);
  }
}

TEST(ScalingPhase, MoreRanksThanThereAreAreRefused) {
  const StudyPlan plan =
      study("sizes = 10\nalgorithms = \"diamond\"\nweak_ranks = { ranks = [1, 2] }\n");
  EXPECT_THROW(require_possible(plan, forced()), InputError);
  SessionPolicy helper = forced();
  helper.timed_phases = false;
  EXPECT_NO_THROW(require_possible(plan, helper));
}

// Four drawings that wait for each other in pairs: a batch on two threads really runs two at once.
TEST(ScalingPhase, ThreadsDrawAtTheSameTime) {
  static std::atomic<int> inside = 0;
  static std::atomic<int> most = 0;
  const Algorithm noting = diamond_drawn_by([](const Graph& graph, const Settings& options) {
    const int now = ++inside;
    int seen = most;
    while (now > seen && !most.compare_exchange_weak(seen, now)) {
    }
    for (int i = 0; i < 20 && most < 2; ++i) usleep(10000);
    --inside;
    return find_algorithm("diamond").draw(graph, options);
  });
  PlannedInstance instance = cycle_of(8, {&noting}, 4, RunPhase::strong);
  for (PlannedRun& run : instance.runs) run.workers = 2;
  make(plan_of(instance), forced());
  EXPECT_EQ(most, 2);
}

// A stop ends a batch with the drawings that have begun; none of its rows is handed on.
TEST(ScalingPhase, AStopEndsABatch) {
  static std::atomic<int> drawn = 0;
  static std::atomic<bool> stopped = false;
  // A thread that draws after the fourth waits for the stop, however slow its thread is.
  const Algorithm stopping = diamond_drawn_by([](const Graph& graph, const Settings& options) {
    const int turn = ++drawn;
    if (turn == 4) {
      std::raise(SIGTERM);
      stopped = true;
    }
    while (turn > 4 && !stopped) std::this_thread::yield();
    return find_algorithm("diamond").draw(graph, options);
  });
  PlannedInstance instance = cycle_of(8, {&stopping}, 500, RunPhase::strong);
  for (PlannedRun& run : instance.runs) run.workers = 2;
  drawn = 0;
  stopped = false;
  const Interruptible interruptible;
  EXPECT_TRUE(make(plan_of(instance), forced()).rows.empty());
  EXPECT_LE(drawn, 6);
}

TEST(HalvesDifference, ComparesTheMediansOfBothHalves) {
  EXPECT_TRUE(std::isinf(halves_difference({})));
  EXPECT_TRUE(std::isinf(halves_difference(std::vector<double>{1})));
  EXPECT_EQ(halves_difference(std::vector<double>{0, 1}), 1);
  EXPECT_EQ(halves_difference(std::vector<double>{9, 1, 2, 2, 1, 9}), 0);
  EXPECT_EQ(halves_difference(std::vector<double>{9, 2, 1, 7, 8}), 2);
}

}  // namespace
}  // namespace ar3d::testing
