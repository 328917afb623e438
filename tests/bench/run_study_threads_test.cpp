#include <csignal>
#include <stdexcept>

#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/store/columns/run_columns.h"
#include "bench/in_memory.h"

namespace ar3d::testing {
namespace {

const char* const kStudy = R"(study = "t"
seed = 3
[[sweep]]
families = "all"
sizes = [6, 30, 60]
algorithms = "all"
instances = 2
repetitions = 2
)";

TEST(RunStudy, TakesOverFinishedRowsAndTellsOnlyTheNewOnes) {
  const StudyPlan plan = plan_study(parse_study(kStudy, "t.toml"));
  const std::vector<RunRecord> all = made_rows(plan, {.workers = 2});
  std::unordered_map<std::string, RunRecord> finished;
  for (std::size_t i = 0; i < all.size(); i += 3) finished[all[i].row_key] = all[i];
  const Made again = make(plan, {.workers = 2}, finished);
  EXPECT_EQ(again.rows.size(), all.size() - finished.size());
  for (const auto& [index, row] : again.rows) {
    EXPECT_NE(index % 3, 0u) << "it is finished";
    EXPECT_TRUE(differing_columns(all[index], row).empty());
  }
}

TEST(RunStudy, StopsWhenAskedTo) {
  const StudyPlan plan = plan_study(parse_study(kStudy, "t.toml"));
  const Interruptible interruptible;
  std::size_t told = 0;
  const auto interrupt = [&] {
    if (++told == 5) std::raise(SIGINT);
  };
  const Made made = make(plan, {.workers = 2}, {}, interrupt);
  EXPECT_GE(made.rows.size(), 5u);
  EXPECT_LE(made.rows.size(), 6u) << "the other thread may finish the row it is at";
}

TEST(RunStudy, AFailingListenerEndsTheStudy) {
  const StudyPlan plan = plan_study(parse_study(kStudy, "t.toml"));
  std::size_t told = 0;
  const auto fail = [&] {
    if (++told == 3) throw std::runtime_error("disk full");
  };
  EXPECT_THROW(make(plan, {.workers = 2}, {}, fail), std::runtime_error);
  EXPECT_EQ(told, 3u);
}

TEST(RunStudy, TellsProgress) {
  std::FILE* out = std::tmpfile();
  ASSERT_NE(out, nullptr);
  run_study(parse_study(kStudy, "t.toml"), {.workers = 2, .progress = out});
  std::rewind(out);
  char line[200] = {};
  ASSERT_NE(std::fgets(line, sizeof(line), out), nullptr);
  std::fclose(out);
  EXPECT_THAT(line, AllOf(StartsWith("study t: "), HasSubstr(" rows, ")));
}

TEST(RunStudy, DescribesWhereItRan) {
  const Results results = describe_study(parse_study(kStudy, "t.toml"), 3);
  EXPECT_EQ(results.created.size(), std::string("2026-01-02T03:04:05.678901+00:00").size());
  const auto& entries = results.environment;
  const auto threads = std::ranges::find(entries, "threads", &EnvironmentEntry::name);
  ASSERT_NE(threads, entries.end());
  EXPECT_EQ(threads->value, "3");
}

}  // namespace
}  // namespace ar3d::testing
