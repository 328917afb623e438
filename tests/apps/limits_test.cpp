// Limits and signals, in every phase of a study and before it.
#include "ar3d/bench/measure/environment.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

class Limits : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return scratch_.path(name); }
  ScratchDirectory scratch_;
};

// All processes of the study are stopped for longer than a row may take, and go on.
TEST_F(Limits, AFrozenStudyHasNoTimeouts) {
  if (std::string(build_kind()) == "sanitised") GTEST_SKIP() << "rows are slower";
  const std::string spec = scratch_.write(
      "t.toml",
      "study = \"t\"\nbudget = { row_time_s = 2 }\n[[sweep]]\nfamilies = \"random-cubic\"\n"
      "sizes = 20000\nalgorithms = \"grid\"\ninstances = 30\n");
  expect_exit(
      0,
      run("{} study run -q --threads 2 " + spec + " -o " + path("t.h5") +
          " & study=$!; until [ \"$(stat -c %s " + path("t.h5.journal") +
          " 2> /dev/null || echo 0)\" -gt 4000 ]; do sleep 0.01; done; workers=$(pgrep -P $study); "
          "kill -STOP $study $workers; sleep 3; kill -CONT $workers $study; wait $study"));
  for (const ar3d::RunRecord& row : read_results(path("t.h5")).runs) {
    EXPECT_EQ(row.status, RunStatus::ok) << row.message;
  }
}

TEST_F(Limits, ChosenRowsAreMadeAgain) {
  const std::string results = path("s.h5");
  must("{} study run smoke -q -o " + results);
  Results changed = read_results(results);
  for (const std::size_t row : {3, 400}) {
    changed.runs[row].status = RunStatus::timeout;
    changed.runs[row].message = "no row within 1 s";
  }
  changed.runs[5].status = RunStatus::crashed;
  write_results(changed, results);
  expect_exit(5, run("{} check " + results));

  expect_error(run("{} study resume -q --again late " + results), "'late'");
  const Outcome again = run("{} study resume -q --again timeout " + results);
  EXPECT_THAT(again.err, HasSubstr("2 of 1080 rows are made again"));
  EXPECT_EQ(again.exit_code, 5) << "one has crashed and was not chosen";
  const Results now = read_results(results);
  ASSERT_EQ(now.runs.size(), changed.runs.size());
  for (std::size_t row = 0; row < now.runs.size(); ++row) {
    if (row == 3 || row == 400) {
      EXPECT_EQ(now.runs[row].status, RunStatus::ok);
    } else {
      EXPECT_EQ(now.runs[row].wall_s, changed.runs[row].wall_s) << row;
    }
  }
  expect_exit(0, run("{} study resume -q --again timeout --again crashed " + results));
  expect_exit(0, run("{} check " + results));
}

// A study that was interrupted has its rows in journals, too.
TEST_F(Limits, RowsOfAnUnfinishedStudyAreMadeAgain) {
  const std::string results = path("s.h5");
  expect_exit(5, run(with_fault("full:60000") + "{} study run smoke -q -o " + results));
  expect_error(run("{} study resume -q --again timeout " + results), "0 of ", 0);
  expect_exit(0, run("{} study status " + results));
}

TEST_F(Limits, HoldForPlanningToo) {
  if (std::string(build_kind()) == "sanitised") GTEST_SKIP() << "memory is not limited";
  const std::string spec = scratch_.write(
      "huge.toml",
      "study = \"huge\"\nbudget = { row_time_s = 3, row_memory_bytes = 64e6 }\n[[sweep]]\n"
      "families = { family = \"torus\", rows = 1000000 }\nsizes = 1000\nalgorithms = \"all\"\n");
  for (const char* verb : {"plan ", "run -q "}) {
    expect_error(run("cd " + path("") + " && {} study " + verb + spec),
                 {"torus rows=1000000 n=", "more than twice budget.row_memory_bytes (64 MB)"});
  }
}

TEST_F(Limits, MergingOneOfVeryManyShardsEnds) {
  const std::string part = path("one.h5");
  expect_exit(2, run("{} study run smoke -q --shard 1/4294967295 -o " + part));
  expect_exit(0, run("{} study run smoke -q --shard 1/1000000 -o " + part));
  expect_error(run("timeout 60 {} study merge " + part + " -o " + path("m.h5")),
               "no file of shard 2-1000000", 5);
}

TEST_F(Limits, AFullStandardOutputIsAnErrorOfEveryVerb) {
  const std::string results = path("s.h5");
  must("{} study run smoke -q -o " + results);
  const std::vector<std::string> commands = {"check " + results,
                                             "report " + results,
                                             "list families",
                                             "replay " + results + " 0",
                                             "study status " + results,
                                             "study plan smoke",
                                             "compare " + results + " " + results,
                                             "generate cycle -n 9 --format edgelist"};
  for (const std::string& command : commands) {
    expect_error(run("{} " + command + " > /dev/full"), "No space left on device");
  }
}

TEST_F(Limits, MisspeltNamesAreTold) {
  const auto error_of = [&](const std::string& toml) {
    const Outcome refused = expect_exit(2, run("{} study plan " + scratch_.write("m.toml", toml)));
    return refused.err;
  };
  const std::string rest = "sizes = 9\nalgorithms = \"diamond\"\n";
  EXPECT_THAT(error_of("study = \"m\"\n[[sweep]]\nfamilys = \"cycle\"\n" + rest),
              HasSubstr("m.toml:3: unknown key 'familys' in sweep; did you mean 'families'?"));
  EXPECT_THAT(error_of("study = \"m\"\n[[sweep]]\nfamilies = \"cycle\"\ninstance = 2\n" + rest),
              HasSubstr("m.toml:4: unknown key 'instance' in sweep; did you mean 'instances'?"));
  EXPECT_THAT(error_of("study = \"m\"\n[[sweep]]\nfamilies = \"cycle\"\ninstances = -2\n" + rest),
              HasSubstr("instances = -2 is outside 1..1000000"));
  expect_error(run("{} study run smoek -q"), "did you mean 'smoke'?");
}

}  // namespace
}  // namespace ar3d::testing
