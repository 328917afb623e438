#include <cmath>

#include "analysis/synthetic.h"
#include "ar3d/analysis/report/report.h"
#include "ar3d/analysis/tally.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d::testing {
namespace {

/// Three instances with extents 10, 30 and 20 in a box of 40 along x.
Results three_instances() {
  Results results;
  for (std::int64_t i = 0; i < 3; ++i) {
    auto run = good_run("grid", "prism", 5, i);
    run.extents = {std::array<std::int64_t, 3>{10, 30, 20}[static_cast<std::size_t>(i)], 4, 0};
    run.theorem_bound = {40, 40, 0};
    run.instance_bound = {32, -1, -1};
    run.published_bound = {60, kMissing, 125};
    run.log2_volume = 10 + static_cast<double>(i);
    results.runs.push_back(run);
  }
  const SizeBound theorem{"here", "a page", {{{8, 1, 2, 0}, {8, 1, 2, 0}, {1, 1, 4, 0}}}};
  const SizeBound published{"paper", "Theorem", {{{12, 1, 2, 0}, {1, 1, 6, 0}, {1, 1, 6, 0}}}};
  const ar3d::RunRecord& run = results.runs.front();
  results.tables = {
      side_table<AlgorithmRecord>({{run.algorithm, run.options, theorem, published}})};
  return results;
}

TEST(BoundsTable, GivesWorstAndMedianSlackPerAxisAndTheWorstRow) {
  const std::vector<CurveTally> entries = curves_of(three_instances());
  ASSERT_EQ(entries.size(), 1u);
  const AxisBounds& x = entries[0].axes[0];
  EXPECT_DOUBLE_EQ(x.worst_slack, 1 - 30.0 / 40);
  EXPECT_DOUBLE_EQ(x.median_slack, 1 - 20.0 / 40);
  EXPECT_EQ(x.worst.row, 1u);
  EXPECT_DOUBLE_EQ(x.worst_instance_slack, 1 - 30.0 / 32);
  EXPECT_EQ(entries[0].axes[1].measured, 3u);
  EXPECT_TRUE(std::isnan(entries[0].axes[1].worst_instance_slack));
  EXPECT_EQ(entries[0].axes[2].measured, 0u) << "a bound of 0 has no relative slack";
  EXPECT_EQ(worst_axis(entries[0]), 0u);
}

TEST(BoundsTable, CountsRowsThatNobodyProved) {
  Results results = three_instances();
  EXPECT_EQ(curves_of(results).at(0).unproved, 0u);
  results.runs[0].certificate = "sample=10";
  results.runs[1].violations = -1;
  const CurveTally entry = curves_of(results).at(0);
  EXPECT_EQ(entry.unproved, 2u);
  EXPECT_EQ(entry.violations, 0u);
}

TEST(BoundsTable, ComparesWithThePublishedBound) {
  const CurveTally entry = curves_of(three_instances()).at(0);
  EXPECT_DOUBLE_EQ(entry.axes[0].worst_published_slack, 1 - 30.0 / 60);
  EXPECT_DOUBLE_EQ(entry.axes[0].median_published_slack, 1 - 20.0 / 60);
  EXPECT_TRUE(std::isnan(entry.axes[1].worst_published_slack));
  EXPECT_EQ(entry.published_formula, "12 n, n^3, n^3 (paper, Theorem)");
  EXPECT_DOUBLE_EQ(entry.log2_volume, 11) << "the median of 10, 11 and 12";
}

/// Whatever order the theorem promises: the same growth of extents and bound gives the same share.
TEST(BoundsTable, VolumesAreSetAgainstTheTheoremsOwnBox) {
  const CurveTally entry = curves_of(good_results({"diamond"}, {"cubic"}, 3, 2)).at(0);
  // Extents of 4n to 4.5n, 4n and 6n in a box of 16n/3, 16n/3 and 8n.
  EXPECT_GT(entry.volume_share, 0.4);
  EXPECT_LT(entry.volume_share, 0.5);
}

TEST(BoundsTable, VolumesAreSetAgainstTheLeastPossible) {
  Results results = three_instances();
  EXPECT_TRUE(std::isnan(curves_of(results).at(0).volume_over_least)) << "no such column";
  for (ar3d::RunRecord& run : results.runs) {
    const std::int64_t least = 256;
    set_metric("volume_at_least", least, run);
  }
  EXPECT_NEAR(curves_of(results).at(0).volume_over_least, 2048.0 / 256, 1e-9);
  EXPECT_TRUE(std::isnan(curves_of(results).at(0).times_the_optimum)) << "not known";
  set_metric("times_the_optimum", 7.5, results.runs[0]);
  EXPECT_EQ(curves_of(results).at(0).times_the_optimum, 7.5);
}

TEST(BoundsTable, OneEntryForEachAlgorithmOptionsFamilyAndParameters) {
  Results results = good_results({"diamond", "grid"}, {"cubic", "prism"}, 2, 2);
  results.runs[0].options = "effort=2";
  const std::vector<CurveTally> entries = curves_of(results);
  ASSERT_EQ(entries.size(), 5u);
  EXPECT_EQ(entries[0].key.options, "effort=2");
  EXPECT_EQ(entries[0].rows, 1u);
  EXPECT_EQ(entries[1].rows, 3u);
  EXPECT_EQ(entries[1].largest_n, 32);
}

TEST(BoundsTable, RepetitionsCountOnceInStatisticsAndBends) {
  Results results = good_results({"diamond"}, {"cubic"}, 1, 2);
  results.runs.push_back(good_run("diamond", "cubic", 16, 0, 1));
  const CurveTally entry = curves_of(results).at(0);
  EXPECT_EQ(entry.rows, 3u);
  EXPECT_EQ(entry.instances, 2u);
  EXPECT_EQ(entry.axes[0].measured, 2u);
  EXPECT_EQ(entry.bends[2], 32u);
}

TEST(BoundsTable, CountsStatusesAndViolations) {
  Results results = good_results({"diamond"}, {"cubic"}, 2, 2);
  results.runs[0].status = RunStatus::timeout;
  results.runs[1].extents[0] = 1000;
  const CurveTally entry = curves_of(results).at(0);
  EXPECT_EQ(entry.count(RunStatus::timeout), 1u);
  EXPECT_EQ(entry.count(RunStatus::ok), 3u);
  EXPECT_EQ(entry.violations, 1u);
  EXPECT_LT(entry.axes[0].worst_slack, 0);
}

TEST(BoundsTable, NothingMeasuredHasNoWorstAxis) {
  Results results = good_results({"diamond"}, {"cubic"}, 1, 1);
  results.runs[0].status = RunStatus::refused;
  EXPECT_FALSE(worst_axis(curves_of(results).at(0)).has_value());
}

TEST(Replay, QuotesWhatAShellWouldRead) {
  auto run = good_run("diamond", "x; rm -rf '$HOME'", 16, 0);
  run.parameters = "k=2;p=750000";
  run.options = "effort=1";
  EXPECT_EQ(draw_command(run),
            "ar3d generate 'x; rm -rf '\\''$HOME'\\''' -n 16 --seed 16000 --set k=2 "
            "--set p=750000 "
            "| ar3d draw - --algorithm diamond --set effort=1");
}

}  // namespace
}  // namespace ar3d::testing
