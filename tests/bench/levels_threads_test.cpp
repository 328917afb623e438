// What a row tells is the same at every level, and on any number of threads.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/analysis/check.h"
#include "ar3d/base/error.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/drawing.h"
#include "ar3d/store/columns/run_columns.h"
#include "bench/in_memory.h"
#include "support/problem.h"

namespace ar3d::testing {
namespace {

const char* const kLevels = R"(study = "levels"
accept_unproved = true
[[sweep]]
families = "all"
sizes = [4, 30, 60]
algorithms = ["all", "two-bend-paper"]
level = ["extents", "positions", "full"]
instances = 2
timed_repetitions = 1
)";

/// A study of one cycle, with more lines.
StudySpec cycle_with(const std::string& lines) {
  return parse_study(
      "study = \"t\"\n[[sweep]]\nfamilies = \"cycle\"\nsizes = 9\nalgorithms = \"diamond\"\n" +
          lines,
      "t.toml");
}

/// The row without what says at which level it was made.
RunRecord without_level(RunRecord run) {
  run.row_key.clear();
  run.level.clear();
  return run;
}

TEST(Levels, TellTheSameBitForBit) {
  const StudySpec spec = parse_study(kLevels, "levels.toml");
  const Results one = run_study(spec, {.workers = 1, .force_timing = true});
  const Results four = run_study(spec, {.workers = 4, .force_timing = true});
  EXPECT_EQ(one.spec_hash, content_hash(kLevels));
  std::map<std::string, std::size_t> rows;
  std::map<std::string, std::size_t> first_of;
  for (std::size_t i = 0; i < one.runs.size(); ++i) {
    const RunRecord& run = one.runs[i];
    EXPECT_EQ(differing_columns(run, four.runs[i]), std::vector<std::string>()) << "row " << i;
    EXPECT_EQ(run.status, RunStatus::ok) << run.family << ' ' << run.algorithm << run.message;
    EXPECT_EQ(std::isnan(run.store_s), run.level == "extents");
    ++rows[run.level];
    const std::string drawing =
        fmt::format("{} {} {} {} {}", run.graph_hash + run.family, run.parameters,
                    run.instance_index, run.algorithm, to_string(run.phase));
    const std::size_t first = first_of.emplace(drawing, i).first->second;
    EXPECT_EQ(differing_columns(without_level(run), without_level(one.runs[first])),
              std::vector<std::string>())
        << run.family << ' ' << run.n << ' ' << run.algorithm << ' ' << run.level;
  }
  EXPECT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows["extents"], rows["full"]);
  EXPECT_EQ(rows["positions"], rows["full"]);
  EXPECT_TRUE(check(Rows(one)).findings.empty());
}

TEST(Levels, CheckFindsLevelsThatDisagree) {
  Results results = run_study(cycle_with("level = [\"extents\", \"full\"]\n"));
  ASSERT_EQ(results.runs.size(), 2u);
  EXPECT_TRUE(check(Rows(results)).findings.empty());
  results.runs[1].bends[0] += 1;
  const auto findings = check(Rows(results)).findings;
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].kind, FindingKind::not_repeatable);
}

std::string error_of(const std::string& level) {
  return problem([&] { cycle_with(level); }, "no error");
}

TEST(Levels, AStudyNamesThemOrIsRefused) {
  EXPECT_EQ(error_of("level = \"full\""), "no error");
  EXPECT_EQ(error_of("level = \"whole\""),
            "t.toml:6: 'whole' is no level (known: extents, positions, full)");
  EXPECT_THAT(error_of("level = []"), HasSubstr("t.toml:6: level is empty"));
  EXPECT_THAT(error_of("level = \"full\"\nstrong = { threads = 1 }"),
              HasSubstr("strong and weak batches are of level extents only"));
}

// Rows of studies that never named a level keep their keys.
TEST(Levels, TheFirstLevelIsTheOneThatRowsAlwaysHad) {
  const StudyPlan plain = plan_study(cycle_with(""));
  const StudyPlan named = plan_study(cycle_with("level = [\"extents\", \"full\"]\n"));
  EXPECT_EQ(plain.instances[0].runs[0].row_key, named.instances[0].runs[0].row_key);
  EXPECT_NE(plain.instances[0].runs[0].row_key, named.instances[0].runs[1].row_key);
  EXPECT_EQ(options_and_level(curve_of(named.instances[0], named.instances[0].runs[1])),
            "effort=1;level=full");
}

TEST(Levels, StoreAsMuchAsTheySay) {
  const Graph graph = generate(find_family("random-4-regular"), 50, 1);
  const Drawing drawing = draw(find_algorithm("diamond"), graph);
  for (const Level level : {Level::extents, Level::positions, Level::full}) {
    const Drawing stored = at_level(drawing, level);
    EXPECT_EQ(parse_level(to_string(level)), level);
    EXPECT_EQ(drawing_hash(stored), drawing_hash(drawing));
    EXPECT_EQ(stored.counters, drawing.counters);
    EXPECT_EQ(stored.instance_bound, drawing.instance_bound);
    EXPECT_EQ(stored.shared_edges(), graph.shared_edges());
    EXPECT_EQ(stored.shared_bends() == drawing.shared_bends(), level != Level::full);
  }
}

}  // namespace
}  // namespace ar3d::testing
