// Limits, budgets and phases through the program as a user runs it.
#include <fmt/format.h>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

std::int64_t rows_of_phase(const Results& results, RunPhase phase) {
  return std::count_if(results.runs.begin(), results.runs.end(),
                       [&](const ar3d::RunRecord& row) { return row.phase == phase; });
}

TEST(MeasuredStudy, IsolatedPhasesPassTheCheck) {
  const ScratchDirectory scratch;
  scratch.write("s.toml", R"(study = "s"
budget = { row_time_s = 60 }
[[sweep]]
families = ["cycle", "random-cubic"]
sizes = { from = 10, to = 40, factor = 2 }
algorithms = ["diamond", "grid"]
timed_repetitions = 2
strong = { threads = [1, 2], drawings = 2 }
)");
  const std::string results = scratch.path("s.h5");
  expect_exit(0, run("{} study run " + scratch.path("s.toml") + " --force-timing --isolate -q -o " +
                     results));
  const Results made = read_results(results);
  EXPECT_EQ(rows_of_phase(made, RunPhase::metrics), 2 * 3 * 2);
  EXPECT_EQ(rows_of_phase(made, RunPhase::timing), 2 * 3 * 2 * 2);
  EXPECT_EQ(rows_of_phase(made, RunPhase::strong), 2 * 3 * 2 * (2 + 2));
  EXPECT_EQ(made.runs.front().peak_scope, "worker");
  expect_exit(0, run("{} replay " + results + " 1"));  // a timing row
}

TEST(MeasuredStudy, EveryStudyIsTimedThatIsAskedTo) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("s.toml", R"(study = "s"
[[sweep]]
families = ["cycle", "square-grid"]
sizes = [9, 16]
algorithms = ["two-bend", "grid"]
[[sweep]]
families = "prism"
sizes = 12
algorithms = "grid"
timed_repetitions = { precision = 0.5, min = 6, max = 8 }
)");
  const std::string results = scratch.path("s.h5");
  const Outcome untimed = run("{} study run " + spec + " -o " + results + " --force-timing");
  expect_exit(0, untimed);
  EXPECT_THAT(untimed.err,
              HasSubstr("left out: two-bend draws degree 3 at most, not square-grid\n"));
  EXPECT_THAT(run("{} study plan " + spec).out,
              HasSubstr("left out: two-bend draws degree 3 at most, not square-grid\n"));
  const Results first = read_results(results);
  EXPECT_GE(rows_of_phase(first, RunPhase::timing), 6);
  // The last line of the progress counts what the verdict counts.
  EXPECT_THAT(untimed.err,
              HasSubstr(fmt::format("study s: {} of 11 to 13 rows", first.runs.size())));
  expect_exit(0,
              run("{} study run " + spec + " -q --force --force-timing --timed 3 -o " + results));
  const Results timed = read_results(results);
  EXPECT_EQ(rows_of_phase(timed, RunPhase::timing), 5 * 3) << "each of the drawings of both sweeps";
  EXPECT_THAT(timed.spec, HasSubstr("timed_repetitions = 3"));
  expect_exit(0, run("{} study resume " + results));
}

TEST(MeasuredStudy, NamedStudiesArePrinted) {
  const ScratchDirectory scratch;
  const Outcome printed = run("{} list studies quick");
  expect_exit(0, printed);
  EXPECT_EQ(printed.out, read_file(AR3D_SOURCE_DIR "/bench/studies/quick.toml"));
  expect_exit(0, run("{} study plan " + scratch.write("q.toml", run("{} list studies smoke").out)));
  expect_one_line(run("{} list studies quik"), "did you mean 'quick'");
  expect_one_line(run("{} list families quick"), "only a study is shown by its name");
  EXPECT_EQ(nlohmann::json::parse(run("{} list studies quick --json").out)["toml"], printed.out);
}

TEST(MeasuredStudy, ThreadsBeyondTheCoresAreMarkedAndCountingIsPlanned) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("s.toml", R"(study = "s"
count = true
[[sweep]]
families = "random-cubic"
sizes = 2000
algorithms = "grid"
strong = { threads = [1, 2], drawings = 2 }
)");
  const Outcome plan = run("taskset -c 0 {} study plan " + spec);
  EXPECT_THAT(plan.out,
              HasSubstr("batches of 2 threads share 1 core: their efficiency says nothing"));
  EXPECT_THAT(plan.out, HasSubstr("counting takes about "));
  EXPECT_GT(nlohmann::json::parse(run("{} study plan --json " + spec).out)["counting_s"], 0);
  const std::string results = scratch.path("s.h5");
  const Outcome made = run("taskset -c 0 {} study run " + spec + " --force-timing -o " + results);
  EXPECT_THAT(made.err, HasSubstr("batches of 2 threads share 1 core"));
  const auto scaling = tables_in(read_file(scratch.path("s.html")))["scaling"];
  for (const auto& row : scaling) EXPECT_EQ(row["crowded"], row["sharers"] == 2);
  EXPECT_EQ(scaling.size(), 2u);
}

TEST(MeasuredStudy, ASpentBudgetEndsTheStudyWithWhatIsDone) {
  const ScratchDirectory scratch;
  scratch.write("s.toml", R"(study = "s"
budget = { study_s = 0.3 }
[[sweep]]
families = "random-cubic"
sizes = [100, 2000]
algorithms = "grid"
instances = 3000
)");
  const std::string results = scratch.path("s.h5");
  expect_error(run("{} study run " + scratch.path("s.toml") + " -q -o " + results), "study resume",
               5);
  const std::size_t rows = read_results(results).runs.size();
  EXPECT_LT(rows, 6000u);
}

TEST(MeasuredStudy, ReplayMakesRowsASampleOrAllAgain) {
  const ScratchDirectory scratch;
  const std::string results = scratch.path("smoke.h5");
  must("{} study run smoke -q -o " + results);
  expect_output(run("{} replay " + results + " --sample 30 --seed 5"),
                "30 equal bit for bit, 0 not");
  const std::string all = fmt::format(
      "{0} of {0} rows made again: {0} equal bit for bit, 0 not, 0 "
      "violated",
      read_results(results).runs.size());
  expect_output(run("{} replay " + results + " --all"), all);
  for (const char* ways : {"", "0 --all", "--all --sample 3", "--keep all --all", "0 --keep all"}) {
    expect_one_line(run("{} replay " + results + " " + ways),
                    "a ROW, --all, --sample K or --keep WHICH, one of them");
  }
  for (const char* vain : {"--all -o x", "--sample 3 -o x", "--keep all --graphs x", "0 --seed 3",
                           "--all --format svg"}) {
    expect_exit(2, run("{} replay " + results + " " + vain));
  }
  Results changed = read_results(results);
  for (ar3d::RunRecord& row : changed.runs) row.longest_edge_length += 1;
  write_results(changed, results);
  expect_output(run("{} replay " + results + " --sample 3"), "differs in longest_edge_length", 3);
  expect_exit(2, run("{} replay " + results + " --sample 0"));
}

TEST(MeasuredStudy, CountedInstructionsHaveNoNoise) {
  const ScratchDirectory scratch;
  scratch.write("s.toml",
                "study = \"s\"\n[[sweep]]\nfamilies = \"random-cubic\"\nsizes = [10, 100]\n"
                "algorithms = \"grid\"\nrepetitions = 2\n");
  const std::string results = scratch.path("s.h5");
  must("{} study run " + scratch.path("s.toml") + " -q -o " + results);
  EXPECT_EQ(read_results(results).runs[0].counted_instructions, -1);
  const Outcome first = run("{} study count --max-n 50 " + results);
  if (std::string(build_kind()) == "sanitised") {
    EXPECT_EQ(first.exit_code, 2);
    EXPECT_THAT(first.err, HasSubstr("sanitised"));
    return;
  }
  EXPECT_EQ(first.exit_code, 0) << first.err;
  const Results counted = read_results(results);
  EXPECT_GT(counted.runs[0].counted_instructions, 1000);
  EXPECT_EQ(counted.runs[1].counted_instructions, counted.runs[0].counted_instructions)
      << "the other repetition is the same drawing";
  EXPECT_EQ(counted.runs[2].counted_instructions, -1) << "n = 100 is above --max-n";
  EXPECT_EQ(run("{} study count --max-n 50 " + results).out, first.out);
  expect_exit(5, run("{} study count --max-n 1 " + results));
}

TEST(MeasuredStudy, ThatIsMadeToBeComparedIsCountedWhereValgrindIs) {
  if (std::string(build_kind()) == "sanitised") GTEST_SKIP() << "cannot run under callgrind";
  const ScratchDirectory scratch;
  const std::string spec =
      scratch.write("s.toml",
                    "study = \"s\"\ncount = true\n[[sweep]]\nfamilies = [\"cycle\", \"prism\"]\n"
                    "sizes = 30\nalgorithms = [\"grid\", \"diamond\"]\n");
  const std::string results = scratch.path("s.h5");
  const std::string command = " {} study run " + spec + " -q --force -o " + results;
  const Outcome without = expect_exit(0, run("PATH=/nowhere" + command));
  EXPECT_THAT(without.err, HasSubstr("drawings are not counted: valgrind cannot be run"));
  EXPECT_EQ(read_results(results).runs[0].counted_instructions, -1);
  expect_output(run("{} study resume -q " + results), "counted  4 drawings");
  for (const ar3d::RunRecord& row : read_results(results).runs) {
    EXPECT_GT(row.counted_instructions, 1000);
    EXPECT_GT(row.estimated_cycles, row.counted_instructions);
  }
  const std::string first = scratch.path("first.h5");
  fs::copy_file(results, first);
  expect_exit(0, run(command));
  EXPECT_THAT(expect_exit(0, run("{} compare " + first + " " + results)).out,
              HasSubstr("4 of 4 cells"));
}

// As where a batch system allows few processes: an error, not the end by std::terminate.
TEST(MeasuredStudy, ThreadsThatTheSystemDoesNotStartAreAnError) {
  if (std::string(build_kind()) == "sanitised") GTEST_SKIP() << "needs all address space";
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("s.toml", R"(study = "s"
[[sweep]]
families = "cycle"
sizes = 30
algorithms = "grid"
strong = { threads = [1, 512] }
)");
  for (const std::string& what :
       {std::string("smoke --threads 1024"), spec + " --force-timing --threads 1"}) {
    const std::string results = scratch.path("r.h5");
    fs::remove(results);
    const Outcome study =
        expect_exit(2, run("ulimit -v 2000000; {} study run -q " + what + " -o " + results));
    EXPECT_THAT(study.err, HasSubstr("ar3d: cannot start ")) << what;
    // What the workers lack is missed before there is a journal; a batch is not.
    EXPECT_EQ(fs::exists(results + ".journal"), what != "smoke --threads 1024");
    if (fs::exists(results + ".journal")) {
      expect_exit(0, run("{} study resume -q --force-timing --threads 2 " + results));
    }
  }
}

TEST(MeasuredStudy, AFailingSpecificationIsRefusedBeforeAnyWork) {
  const ScratchDirectory scratch;
  scratch.write("s.toml",
                "study = \"s\"\nbudget = { row_time_s = \"2\" }\n[[sweep]]\nfamilies = \"cycle\"\n"
                "sizes = 10\nalgorithms = \"grid\"\n");
  expect_error(run("{} study run " + scratch.path("s.toml") + " -q -o " + scratch.path("s.h5")),
               "s.toml:2: row_time_s is not a number");
}

}  // namespace
}  // namespace ar3d::testing
