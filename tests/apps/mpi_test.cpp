// One study on several processes that mpirun starts.
#include <fmt/format.h>

#include <map>
#include <set>

#include "apps/failing_rank.h"
#include "ar3d/bench/measure/environment.h"
#include "support/program.h"
#include "support/results.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

const char* const kPhases = R"(study = "phases"
[[sweep]]
families = ["random-cubic", "cycle"]
sizes = [40, 200]
algorithms = "grid"
instances = 20
timed_repetitions = 2
)";

class Mpi : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return scratch_.path(name); }
  std::string ranks(int count) const {
    return fmt::format("mpirun --allow-run-as-root --oversubscribe -n {} {} ", count,
                       AR3D_MPI_PROGRAM);
  }

  ScratchDirectory scratch_;
};

TEST_F(Mpi, FourRanksMakeTheSameRows) {
  const Outcome four = expect_exit(0, run(ranks(4) + "study run smoke -q -o " + path("four.h5")));
  EXPECT_THAT(four.out, HasSubstr("results  " + path("four.h5")));
  expect_exit(0, run("{} study run smoke -q -o " + path("one.h5")));
  expect_same_rows(path("four.h5"), path("one.h5"));
  // Rank i has made every fourth graph of the plan, from the i-th on.
  const Results results = read_results(path("four.h5"));
  std::map<std::int64_t, std::string> rank_of_session;
  for (const EnvironmentEntry& entry : results.environment) {
    if (entry.name == "rank") rank_of_session[entry.session] = entry.value;
  }
  EXPECT_EQ(rank_of_session.size(), 4u);
  std::string last;
  int graphs = 0;
  for (const ar3d::RunRecord& row : results.runs) {
    const std::string graph =
        fmt::format("{} {} {} {}", row.family, row.parameters, row.requested_n, row.instance_index);
    if (graph != std::exchange(last, graph)) ++graphs;
    EXPECT_EQ(rank_of_session[row.session], fmt::format("{} of 4", (graphs - 1) % 4)) << graph;
  }
  EXPECT_EQ(graphs, 214);
  EXPECT_EQ(run("ls " + path("*.journal")).out, "");
}

TEST_F(Mpi, ThePlainProgramNamesTheOther) {
  expect_one_line(run("OMPI_COMM_WORLD_SIZE=2 {} study run smoke"), "ar3d-mpi shares the rows");
}

TEST_F(Mpi, OneRankMakesAllRows) {
  const Outcome one = expect_exit(0, run(ranks(1) + "study run smoke -q -o " + path("one.h5")));
  expect_exit(0, run("{} study run smoke -q -o " + path("alone.h5")));
  expect_same_rows(path("one.h5"), path("alone.h5"));
}

TEST_F(Mpi, TimedRowsAreMadeByTheFirstRankAlone) {
  const std::string spec = scratch_.write("phases.toml", kPhases);
  const Outcome two = expect_exit(
      0, run(ranks(2) + "study run -q --force-timing " + spec + " -o " + path("two.h5")));
  expect_exit(0, run("{} study run -q --force-timing " + spec + " -o " + path("one.h5")));
  expect_same_rows(path("two.h5"), path("one.h5"));
  std::set<std::int64_t> timing_sessions;
  for (const ar3d::RunRecord& row : read_results(path("two.h5")).runs) {
    if (row.phase == RunPhase::timing) timing_sessions.insert(row.session);
  }
  EXPECT_EQ(timing_sessions.size(), 1u);
}

// The budget is one for all phases: where the first has spent it, nothing is timed.
TEST_F(Mpi, ASpentBudgetIsNotBegunAnew) {
  const std::string spec = scratch_.write("spent.toml", R"(study = "spent"
budget = { study_s = 0.3 }
[[sweep]]
families = "random-cubic"
sizes = 1000
algorithms = "grid"
instances = 10000
timed_repetitions = 1
)");
  expect_exit(5, run(ranks(2) + "study run -q --force-timing " + spec + " -o " + path("r.h5")));
  const Results results = read_results(path("r.h5"));
  EXPECT_GT(results.runs.size(), 0u);
  for (const ar3d::RunRecord& row : results.runs) ASSERT_EQ(row.phase, RunPhase::metrics);
}

const char* const kBatches = R"(study = "batches"
[[sweep]]
families = { family = "random-cubic", shuffle = 1 }
sizes = [40, 2000]
algorithms = ["grid", "two-bend"]
strong_ranks = { ranks = [1, 3], drawings = 5, repetitions = 2 }
weak_ranks = { ranks = [1, 2], drawings = 2 }
)";

// Which rank drew a row is seen by its batch alone; the rows are those of the plan, all of them
// drawn and certified, however many ranks stand idle.
TEST_F(Mpi, BatchesAreSharedByRanks) {
  const std::string spec = scratch_.write("batches.toml", kBatches);
  const Outcome three = expect_exit(
      0, run(ranks(3) + "study run -q --force-timing " + spec + " -o " + path("three.h5")));
  std::map<std::pair<RunPhase, std::int64_t>, int> rows;
  for (const ar3d::RunRecord& row : read_results(path("three.h5")).runs) {
    EXPECT_EQ(row.status, RunStatus::ok) << row.message;
    if (row.phase == RunPhase::metrics) continue;
    ++rows[{row.phase, row.workers}];
    EXPECT_EQ(row.violations, 0);
    EXPECT_EQ(row.concurrency, row.workers);
    EXPECT_GT(row.wall_s, 0);
    EXPECT_GE(row.batch_s, row.wall_s);
    EXPECT_DOUBLE_EQ(row.efficiency, row.ideal_batch_s / row.batch_s);
  }
  EXPECT_EQ(rows.size(), 4u);
  EXPECT_EQ((rows[{RunPhase::strong_ranks, 1}]), 4 * 5 * 2);
  EXPECT_EQ((rows[{RunPhase::strong_ranks, 3}]), 4 * 5 * 2);
  EXPECT_EQ((rows[{RunPhase::weak_ranks, 2}]), 4 * 2 * 2);
  expect_exit(0, run(ranks(4) + "study run -q --force-timing " + spec + " -o " + path("four.h5")));
  expect_same_rows(path("three.h5"), path("four.h5"));
  expect_exit(0, run("{} check " + path("three.h5")));
  const auto scaling = tables_in(run("cat " + path("three.html")).out)["scaling"];
  EXPECT_GT(rows_with(scaling, "shared_by", "ranks").size(), 0u);
}

// One core does a second's work in a second: a batch lasts as long as the processor's time of all
// its drawings, however late a rank begins.
TEST_F(Mpi, ThreeRanksOnOneCoreAreNoFasterThanOne) {
  const std::string spec = scratch_.write("crowd.toml", R"(study = "crowd"
[[sweep]]
families = "random-cubic"
sizes = 200
algorithms = "grid"
strong_ranks = { ranks = [1, 3], drawings = 9, repetitions = 5 }
)");
  const std::string one_core = "taskset -c $(taskset -pc $$ | sed 's/.*: //; s/[,-].*//') ";
  const Outcome crowd = expect_exit(
      0,
      run(one_core + "mpirun --allow-run-as-root --oversubscribe --bind-to none -n 3 " +
          AR3D_MPI_PROGRAM + " study run -q --force-timing " + spec + " -o " + path("crowd.h5")));
  std::map<std::pair<std::int64_t, double>, double> cpu_s;  // of a batch: its scale and time
  for (const ar3d::RunRecord& row : read_results(path("crowd.h5")).runs) {
    if (row.phase == RunPhase::strong_ranks) cpu_s[{row.workers, row.batch_s}] += row.cpu_s;
  }
  EXPECT_EQ(cpu_s.size(), 10u);
  for (const auto& [batch, sum] : cpu_s) EXPECT_LE(sum, batch.second) << batch.first << " ranks";
}

TEST_F(Mpi, BatchesForMoreRanksThanThereAreAreRefused) {
  const std::string spec = scratch_.write("batches.toml", kBatches);
  expect_error(run(ranks(2) + "study run -q --force-timing " + spec + " -o " + path("r.h5")),
               "ar3d: batches are to be shared by 3 ranks of mpirun but there are 2\n");
  const Outcome alone =
      expect_exit(2, run("{} study run -q --force-timing " + spec + " -o " + path("r.h5")));
  EXPECT_EQ(alone.err, "ar3d: batches are to be shared by 3 ranks of mpirun but there is 1\n");
  EXPECT_EQ(run("ls " + path("r.*")).out, "") << "nothing was begun";
}

// Killed with all ranks, then finished by one process; by more ranks than before; merged by hand.
TEST_F(Mpi, IsResumedByAnyNumberOfRanks) {
  const std::string results = path("r.h5");
  const std::string spec = scratch_.write(
      "slow.toml",
      "study = \"slow\"\n[[sweep]]\nfamilies = \"random-cubic\"\nsizes = 20000\nalgorithms = "
      "\"grid\"\ninstances = 60\n");
  expect_exit(0, run("{} study run -q " + spec + " -o " + path("whole.h5")));
  for (const std::string& again : {std::string("{} "), ranks(3)}) {
    run(ranks(2) + "study run -q " + spec + " -o " + results + " & until [ \"$(stat -c %s " +
        results + ".rank-1.journal 2> /dev/null || echo 0)\" -gt 16000 ]; do sleep 0.01; done; " +
        "kill -KILL $(pgrep -f ^[^[:space:]]*ar3d-mpi.*" + results + "); wait");
    ASSERT_TRUE(fs::exists(results + ".rank-1.journal"));
    expect_exit(5, run("{} study status " + results));
    expect_exit(0, run(again + "study resume -q " + results));
    expect_same_rows(results, path("whole.h5"));
    fs::remove(results);
  }
}

// What only rank 0 does, and what only rank 1 suffers: no rank waits for one that is gone.
TEST_F(Mpi, NoRankIsWaitedForInVain) {
  fs::create_directories(path("r.h5.partial-1/not-empty"));
  expect_exit(0, run("timeout 60 " + ranks(2) + "study run smoke -q -o " + path("r.h5")));
  if (std::string(build_kind()) == "sanitised") return;  // needs all address space

  std::string jumps = "1";
  for (int k = 2; k <= 500; ++k) jumps += ", " + std::to_string(k);
  const std::string spec = scratch_.write(
      "wide.toml",
      "study = 'wide'\n[[sweep]]\nfamilies = { family = 'generalised-petersen', k = [" + jumps +
          "] }\nsizes = { from = 4, to = 100000, per_decade = 500 }\n"
          "algorithms = 'grid'\n");
  const std::string program =
      std::string(AR3D_MPI_PROGRAM) + " study run -q " + spec + " -o " + path("w.h5");
  const Outcome alone = run("timeout 60 mpirun --allow-run-as-root --oversubscribe -n 1 " +
                            program + " : -n 1 bash -c 'ulimit -v 600000; exec " + program + "'");
  EXPECT_THAT(alone.err, HasSubstr("ar3d: rank 1: "));
  EXPECT_EQ(alone.exit_code, 1);
}

// Rank 1 cannot read the rows so far; rank 0, which can, must not wait for it.
TEST_F(Mpi, ARankThatCannotReadEndsAll) {
  const std::string shim = with_fault("read:1") + AR3D_MPI_PROGRAM;
  expect_exit(5, run(with_fault("full:60000") + "{} study run smoke -q -o " + path("r.h5")));
  const std::string resume = " study resume -q " + path("r.h5");
  expect_error(run("timeout 60 mpirun --allow-run-as-root --oversubscribe -n 1 " +
                   std::string(AR3D_MPI_PROGRAM) + resume + " : -n 1 " + shim + resume),
               "r.h5.journal: Input/output error");
  expect_exit(0, run("{} study resume -q " + path("r.h5")));
}

// Every rank's calls on the study's files fail in turn; tests/apps/kill_everywhere_long_test.cpp
// makes all of them fail.
TEST_F(Mpi, AFailureOfOneRankAtAnyOfItsCallsEndsAll) {
  must("{} study run smoke -q -o " + path("whole.h5"));
  for (const int call : {1, 2, 4, 9}) {
    for (const int rank : {0, 1}) {
      EXPECT_TRUE(expect_failure_ends_all(scratch_, path("whole.h5"), rank, call)) << call;
    }
  }
}

// Rank 1 is late with the end of its session, and rank 0 is killed between the journals' removals.
TEST_F(Mpi, AKillBetweenTheRemovalsOfJournalsIsResumed) {
  must("{} study run smoke -q -o " + path("whole.h5"));
  const std::string study =
      std::string(AR3D_MPI_PROGRAM) + " study run smoke -q -o " + path("r.h5");
  for (const int removal : {1, 2}) {
    for (const int milliseconds : {5, 40}) {
      run(fmt::format("timeout 60 mpirun --allow-run-as-root --oversubscribe -n 1 {}{} : -n 1 {}{}",
                      with_fault(fmt::format("unlink:{}", removal)), study,
                      with_fault(fmt::format("late:{}", milliseconds)), study));
      EXPECT_EQ(run("ls " + path("") + " | grep -c r.h5.*journal").out,
                fmt::format("{}\n", 3 - removal))
          << "it was killed there";
      expect_exit(0, run("{} study resume -q " + path("r.h5")));
      expect_same_rows(path("r.h5"), path("whole.h5"));
      must("rm " + path("r.*"));
    }
  }
}

TEST_F(Mpi, AnErrorOfAllRanksIsOneLine) {
  const Outcome refused = expect_exit(2, run(ranks(3) + "study run smoke -q -o /proc/s.h5"));
  const std::size_t first = refused.err.find("ar3d: cannot write /proc/s.h5");
  ASSERT_NE(first, std::string::npos) << refused.err;
  EXPECT_EQ(refused.err.find("ar3d: cannot write", first + 1), std::string::npos);
}

}  // namespace
}  // namespace ar3d::testing
