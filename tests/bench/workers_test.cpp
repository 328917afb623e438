// One bad row costs one row: seeded loops, crashes and allocations in worker processes.
#include <fcntl.h>
#include <omp.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/store/columns/run_columns.h"
#include "bench/in_memory.h"
#include "bench/seeded.h"

namespace ar3d::testing {
namespace {

SessionPolicy isolated() {
  SessionPolicy policy;
  policy.isolate = true;
  return policy;
}

StudyPlan within(const LimitByVertices& seconds, StudyPlan plan) {
  plan.budget.row_time_s = seconds;
  return plan;
}

// No child of this process is left, running or dead.
void expect_no_children() { EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left"; }

Drawing good_drawing(const Graph& graph, const Settings& options) {
  return find_algorithm("diamond").draw(graph, options);
}

const Algorithm kAborts =
    diamond_drawn_by([](const Graph&, const Settings&) -> Drawing { std::abort(); });
const Algorithm kSegfaults = diamond_drawn_by([](const Graph&, const Settings&) -> Drawing {
  raise(SIGSEGV);
  std::abort();
});
const Algorithm kLeaves =
    diamond_drawn_by([](const Graph&, const Settings&) -> Drawing { _exit(7); });
const Algorithm kLoops = diamond_drawn_by([](const Graph&, const Settings&) -> Drawing {
  for (std::atomic<std::uint64_t> i = 0;; ++i) {
  }
});
const Algorithm kGood = diamond_drawn_by(good_drawing);

TEST(Workers, ACrashIsARowAndTheOthersGoOn) {
  const auto rows = made_rows(
      plan_of(cycle_of(8, {&kAborts, &kGood, &kSegfaults, &kLeaves, &kGood})), isolated());
  EXPECT_EQ(rows[0].status, RunStatus::crashed);
  EXPECT_THAT(rows[0].message, HasSubstr("Aborted"));
  EXPECT_EQ(rows[0].n, 8) << "what was known before the crash is in the row";
  EXPECT_EQ(rows[0].graph_hash, rows[1].graph_hash);
  EXPECT_EQ(rows[0].violations, -1);
  EXPECT_EQ(rows[1].status, RunStatus::ok) << rows[1].message;
  EXPECT_EQ(rows[2].status, RunStatus::crashed);
  EXPECT_EQ(rows[3].status, RunStatus::crashed);
  EXPECT_EQ(rows[3].message, "exited with code 7");
  EXPECT_EQ(rows[4].status, RunStatus::ok) << rows[4].message;
  EXPECT_EQ(rows[4].peak_scope, "worker");
  expect_no_children();
}

TEST(Workers, ALoopIsATimeoutAndNothingOfItIsLeft) {
  static int pipe_ends[2];
  ASSERT_EQ(pipe2(pipe_ends, O_CLOEXEC), 0);
  // The row starts a process of its own, which would live for ever: it must go with the worker. It
  // holds the pipe open (a worker closes all it inherits, so it is opened anew).
  static std::string path;
  path = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(pipe_ends[1]);
  const Algorithm forks = diamond_drawn_by([](const Graph&, const Settings&) -> Drawing {
    const int held = open(path.c_str(), O_WRONLY);
    if (fork() == 0) {
      for (;;) pause();
    }
    for (;;) pause();
    close(held);
    std::abort();
  });
  const auto rows =
      made_rows(within({0.3, 1e-6}, plan_of(cycle_of(8, {&kGood, &kLoops, &forks, &kGood}))));
  EXPECT_EQ(rows[1].status, RunStatus::timeout);
  EXPECT_EQ(rows[1].message, "no row within 0.300008 s");
  EXPECT_EQ(rows[2].status, RunStatus::timeout);
  EXPECT_EQ(rows[0].status, RunStatus::ok);
  EXPECT_EQ(rows[3].status, RunStatus::ok);
  expect_no_children();
  close(pipe_ends[1]);
  char byte = 0;
  EXPECT_EQ(read(pipe_ends[0], &byte, 1), 0) << "the end of the file: no process holds the pipe";
  close(pipe_ends[0]);
}

TEST(Workers, AGeneratorThatHangsIsTriedOnceAnInstance) {
  static Family family = find_family("cycle");
  family.generate = [](std::uint64_t, std::uint64_t, const Settings&) -> Graph {
    for (;;) pause();
  };
  PlannedInstance instance = cycle_of(8, {&kGood}, 50);
  instance.choice.family = &family;
  const auto rows = made_rows(within({0.2, 0}, plan_of(instance)));
  for (const RunRecord& run : rows) {
    EXPECT_EQ(run.status, RunStatus::timeout);
    EXPECT_EQ(run.message, "no graph within 0.2 s");
    EXPECT_EQ(run.n, -1);
  }
}

// 1 GiB in pieces, so that it is no single absurd request.
const Algorithm kGreedy = diamond_drawn_by([](const Graph& graph, const Settings& options) {
  std::vector<std::vector<char>> pieces;
  for (int i = 0; i < 64; ++i) pieces.emplace_back(std::size_t{16} << 20, 'x');
  return good_drawing(graph, options);
});

TEST(Workers, TooMuchMemoryIsOutOfMemory) {
  StudyPlan plan = plan_of(cycle_of(8, {&kGreedy, &kGood}));
  plan.budget.row_memory_bytes = LimitByVertices{128 << 20, 1000};
  if (std::string(build_kind()) == "sanitised") {
    EXPECT_THROW(require_possible(plan, {}), InputError);
    return;
  }
  const auto rows = made_rows(plan);
  EXPECT_EQ(rows[0].status, RunStatus::out_of_memory);
  EXPECT_EQ(rows[1].status, RunStatus::ok) << rows[1].message;
  plan.budget.row_memory_bytes = LimitByVertices{2147483648, 0};
  EXPECT_EQ(made_rows(plan)[0].status, RunStatus::ok) << "the limit was what stopped it";
}

TEST(Workers, RowsAreTheSameAsInThreads) {
  const StudyPlan plan = plan_study(parse_study(
      "study = \"t\"\n[[sweep]]\nfamilies = \"all\"\nsizes = [6, 30]\nalgorithms = \"all\"\n",
      "t.toml"));
  SessionPolicy policy = isolated();
  policy.workers = 3;
  const auto in_workers = made_rows(plan, policy);
  policy.isolate = false;
  const auto in_threads = made_rows(plan, policy);
  for (std::size_t i = 0; i < plan.rows(); ++i) {
    EXPECT_THAT(differing_columns(in_workers[i], in_threads[i]), ElementsAre()) << i;
    EXPECT_EQ(in_workers[i].concurrency, 3);
  }
  expect_no_children();
}

// Graphs of this size are generated by several threads; a process that is forked after they have
// been used has to do without them.
TEST(Workers, GenerateLargeGraphsAfterThreadsWereUsed) {
  omp_set_num_threads(2);
  const std::uint64_t n = 100000;
  generate(find_family("random-cubic"), n, 1);
  PlannedInstance instance = cycle_of(n, {&kGood});
  instance.choice.family = &find_family("random-cubic");
  instance.choice.parameters = complete_parameters(*instance.choice.family, {});
  EXPECT_EQ(made_rows(within({60, 0}, plan_of(instance)))[0].status, RunStatus::ok);
}

TEST(Workers, AStopGivesUpTheRowsInFlight) {
  const StudyPlan plan = plan_of(cycle_of(8, {&kGood, &kLoops, &kGood}));
  const Interruptible interruptible;
  EXPECT_THAT(make(plan, isolated(), {}, [] { std::raise(SIGINT); }).order, ElementsAre(0));
  expect_no_children();
}

TEST(Workers, TheStudysBudgetEndsItWithWhatIsDone) {
  StudyPlan plan = plan_of(cycle_of(8, {&kGood, &kLoops}));
  plan.budget.study_s = 0.5;
  EXPECT_THAT(make(plan, isolated()).order, ElementsAre(0));
  expect_no_children();
}

// It writes into every descriptor that it finds, the one its rows go through among them.
TEST(Workers, GarbageOnTheSocketIsACrashOfTheRow) {
  const Algorithm garbles = diamond_drawn_by([](const Graph& graph, const Settings& options) {
    const std::string garbage(100000, 'm');
    for (int file = 3; file < 64; ++file) {
      (void)!::send(file, garbage.data(), garbage.size(), MSG_NOSIGNAL);
    }
    return good_drawing(graph, options);
  });
  const auto rows = made_rows(plan_of(cycle_of(8, {&kGood, &garbles, &kGood})), isolated());
  EXPECT_EQ(rows[0].status, RunStatus::ok);
  EXPECT_EQ(rows[1].status, RunStatus::crashed);
  EXPECT_THAT(rows[1].message, HasSubstr("wrote into the socket"));
  EXPECT_EQ(rows[2].status, RunStatus::ok) << rows[2].message;
  expect_no_children();
}

// The study's process is killed while a row hangs: the worker goes with it.
TEST(Workers, DieWithTheirParent) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const pid_t study = fork();
  ASSERT_GE(study, 0);
  if (study == 0) {
    static std::string path;
    path = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(ends[1]);
    const Algorithm tells = diamond_drawn_by([](const Graph&, const Settings&) -> Drawing {
      const int held = open(path.c_str(), O_WRONLY);
      if (write(held, "x", 1) == 1) {
        for (;;) pause();
      }
      std::abort();
    });
    make(plan_of(cycle_of(8, {&tells})), isolated());
    _exit(0);
  }
  close(ends[1]);
  char byte = 0;
  ASSERT_EQ(read(ends[0], &byte, 1), 1) << "the row has begun in a worker";
  kill(study, SIGKILL);
  ASSERT_EQ(waitpid(study, nullptr, 0), study);
  EXPECT_EQ(read(ends[0], &byte, 1), 0) << "the end of the file: the worker is gone too";
  close(ends[0]);
}

TEST(Workers, WhatTheListenerThrowsIsPassedOn) {
  const auto fail = [] { throw std::runtime_error("disk full"); };
  EXPECT_THROW(make(plan_of(cycle_of(8, {&kGood, &kGood})), isolated(), {}, fail),
               std::runtime_error);
  expect_no_children();
}

}  // namespace
}  // namespace ar3d::testing
