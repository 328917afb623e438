#include <csignal>
#include <set>
#include <stdexcept>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/run/describe_study.h"
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

TEST(RunStudy, SameColumnsOnAnyNumberOfThreads) {
  const StudySpec spec = parse_study(kStudy, "t.toml");
  const Results one = run_study(spec, {.workers = 1});
  EXPECT_EQ(one.runs.size(), plan_study(spec).rows());
  EXPECT_EQ(one.spec_hash, content_hash(kStudy));
  for (const int threads : {2, 4}) {
    const Results many = run_study(spec, {.workers = threads});
    ASSERT_EQ(many.runs.size(), one.runs.size());
    for (std::size_t i = 0; i < one.runs.size(); ++i) {
      EXPECT_EQ(differing_columns(one.runs[i], many.runs[i]), std::vector<std::string>())
          << "row " << i;
    }
  }
  for (const RunRecord& run : one.runs) {
    EXPECT_EQ(run.status, RunStatus::ok)
        << run.family << ' ' << run.n << ' ' << run.algorithm << ": " << run.message;
  }
}

TEST(RunStudy, SmokeIsAllRight) {
  const StudySpec spec = load_study("smoke");
  const Results results = run_study(spec, {.workers = 2});
  EXPECT_EQ(results.runs.size(), plan_study(spec).rows());
  std::set<std::string> algorithms_seen;
  for (const RunRecord& run : results.runs) {
    EXPECT_EQ(run.status, RunStatus::ok) << run.row_key << ": " << run.message;
    algorithms_seen.insert(run.algorithm);
  }
  EXPECT_EQ(algorithms_seen.size(), proved_algorithms().size());
}

TEST(RunStudy, TakesOverFinishedRowsAndTellsOnlyTheNewOnes) {
  const StudyPlan plan = plan_study(parse_study(kStudy, "t.toml"));
  const std::vector<RunRecord> all = run_plan(plan, {.workers = 2});
  std::unordered_map<std::string, RunRecord> finished;
  for (std::size_t i = 0; i < all.size(); i += 3) finished[all[i].row_key] = all[i];
  std::size_t made = 0;
  const std::vector<RunRecord> again =
      run_plan(plan, {.workers = 2}, finished, [&](const RunRecord& run) {
        EXPECT_FALSE(finished.contains(run.row_key));
        ++made;
      });
  EXPECT_EQ(made, all.size() - finished.size());
  ASSERT_EQ(again.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_TRUE(differing_columns(all[i], again[i]).empty());
}

TEST(RunStudy, StopsWhenAskedTo) {
  const StudyPlan plan = plan_study(parse_study(kStudy, "t.toml"));
  const Interruptible interruptible;
  std::size_t made = 0;
  const auto rows = run_plan(plan, {.workers = 2}, {}, [&](const RunRecord&) {
    if (++made == 5) std::raise(SIGINT);
  });
  EXPECT_EQ(rows.size(), made);
  EXPECT_GE(rows.size(), 5u);
  EXPECT_LE(rows.size(), 6u) << "the other thread may finish the row it is at";
}

TEST(RunStudy, AFailingListenerEndsTheStudy) {
  const StudyPlan plan = plan_study(parse_study(kStudy, "t.toml"));
  std::size_t told = 0;
  EXPECT_THROW(run_plan(plan, {.workers = 2}, {},
                        [&](const RunRecord&) {
                          if (++told == 3) throw std::runtime_error("disk full");
                        }),
               std::runtime_error);
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
  EXPECT_EQ(std::string(line).find("study t: "), 0u);
  EXPECT_NE(std::string(line).find(" rows, "), std::string::npos);
}

TEST(RunStudy, DescribesWhereItRan) {
  const Results results = describe_study(parse_study(kStudy, "t.toml"), 3);
  EXPECT_EQ(results.created.size(), std::string("2026-01-02T03:04:05.678901+00:00").size());
  std::vector<std::string> names;
  for (const EnvironmentEntry& entry : results.environment) {
    EXPECT_FALSE(entry.value.empty()) << entry.name;
    if (entry.name == "threads") {
      EXPECT_EQ(entry.value, "3");
    }
    names.push_back(entry.name);
  }
  EXPECT_NE(std::find(names.begin(), names.end(), "library_hdf5"), names.end());
}

}  // namespace
}  // namespace ar3d::testing
