// The way from a study to a verdict, through the program as a user runs it.
#include "support/program.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

TEST(StudyProgram, SmokeRunsChecksReportsAndReplays) {
  const ScratchDirectory scratch;
  const std::string results = scratch.path("smoke.h5");
  expect_output(run("{} study run smoke --quiet -o " + results),
                {results, scratch.path("smoke.html")});
  EXPECT_GT(tables_in(read_file(scratch.path("smoke.html")))["curves"].size(), 0u);

  expect_exit(0, run("{} check " + results));
  expect_exit(0, run("{} report " + results + " -o " + scratch.path("again.html")));
  EXPECT_EQ(read_file(scratch.path("again.html")), read_file(scratch.path("smoke.html")));

  const Outcome replay =
      expect_exit(0, run("{} replay " + results + " 0 -o " + scratch.path("row.jsonl")));
  EXPECT_THAT(replay.out, HasSubstr("equal, bit for bit"));
  expect_exit(0, run("{} verify " + scratch.path("row.jsonl")));
  expect_exit(2, run("{} replay " + results + " 99999999"));
}

TEST(StudyProgram, PlanShowsWhatWouldBeDone) {
  expect_output(run("{} study plan quick"), " instances, ");
}

TEST(StudyProgram, InterruptedKeepsTheRowsMadeSoFar) {
  const ScratchDirectory scratch;
  const std::string results = scratch.path("quick.h5");
  expect_error(run("timeout --preserve-status -s INT 3 {} study run quick --quiet -o " + results),
               "interrupted", 130);
  EXPECT_NE(run("{} check " + results).exit_code, 2) << "the file is whole";
}

TEST(VerifyProgram, EveryCrossingTestGivesTheSameVerdict) {
  for (const char* test : {"automatic", "all-pairs", "halving"}) {
    expect_output(
        run(std::string("{} generate random-cubic -n 30 | {} draw - --algorithm grid | {} verify - "
                        "--crossing-test ") +
            test),
        "1 certified, 0 violated");
  }
}

TEST(ListProgram, ShowsEveryCatalogue) {
  const Outcome list = expect_exit(0, run("{} list"));
  for (const char* entry :
       {"diamond", "grid", "two-bend", "random-cubic", "graph6", "log2_volume", "smoke"}) {
    EXPECT_THAT(list.out, HasSubstr(entry));
  }
}

TEST(Program, HelpOfEveryVerbHasAnExample) {
  for (const char* verb : {"list", "generate", "draw", "verify", "study run", "study resume",
                           "study status", "study merge", "study plan", "study count", "check",
                           "report", "replay", "compare", "hunt", "shrink"}) {
    expect_output(run(std::string("{} ") + verb + " --help"), "Example: ");
  }
}

}  // namespace
}  // namespace ar3d::testing
