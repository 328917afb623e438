// What one pass over the rows keeps: the same whatever their order, and no more than stated.
#include "ar3d/analysis/tally.h"

#include <cmath>
#include <limits>

#include "analysis/synthetic.h"
#include "ar3d/analysis/check.h"
#include "ar3d/analysis/report/report.h"
#include "ar3d/analysis/scaling/scaling.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d::testing {
namespace {

/// Three repetitions of every graph, with times of their own.
Results repeated() {
  Results results = good_results({"diamond", "grid"}, {"cubic", "prism"}, 4, 3);
  const std::vector<ar3d::RunRecord> first = results.runs;
  for (std::int64_t repetition = 1; repetition < 3; ++repetition) {
    for (ar3d::RunRecord run : first) {
      run.repetition = repetition;
      run.wall_s *= static_cast<double>(1 + repetition);
      results.runs.push_back(run);
    }
  }
  return results;
}

TEST(Tally, RepetitionsAreOneGraphWhereverTheirRowsStand) {
  const Results apart = repeated();
  Results together = apart;
  std::stable_sort(together.runs.begin(), together.runs.end(), [](const auto& a, const auto& b) {
    return std::tie(a.algorithm, a.family, a.n, a.instance_index) <
           std::tie(b.algorithm, b.family, b.n, b.instance_index);
  });
  const StudyTally one = tally_of(apart), two = tally_of(together);
  ASSERT_EQ(one.curves.size(), 4u);
  ASSERT_EQ(two.curves.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(one.curves[i].key, two.curves[i].key);
    EXPECT_EQ(one.curves[i].rows, 36u);
    EXPECT_EQ(one.curves[i].instances, 12u);
    for (const auto& [n, size] : one.curves[i].sizes) {
      const SizeTally& other = two.curves[i].sizes.at(n);
      ASSERT_EQ(size.graphs.size(), 3u);
      for (std::size_t g = 0; g < 3; ++g) {
        EXPECT_EQ(size.graphs[g].seed, other.graphs[g].seed);
        EXPECT_EQ(size.graphs[g].log_wall_s, other.graphs[g].log_wall_s);
      }
    }
  }
  const ar3d::RunRecord& run = apart.runs[0];
  EXPECT_DOUBLE_EQ(one.curves[0].sizes.at(16).graphs[0].log_wall_s, std::log(2 * run.wall_s))
      << "the median of its times 1, 2 and 3";
}

TEST(Tally, MeasuredRowsAreDrawnRowsWithoutABound) {
  Results results = good_results({"grid", "peer"}, {"cubic"}, 4, 3);
  const double kNoBound = std::numeric_limits<double>::quiet_NaN();
  for (ar3d::RunRecord& run : results.runs) {
    if (run.algorithm != "peer") continue;
    run.status = RunStatus::measured;
    run.violations = -1;
    run.theorem_bound = run.published_bound = {kNoBound, kNoBound, kNoBound};
    run.instance_bound = {-1, -1, -1};
  }
  const StudyTally tally = tally_of(results);
  ASSERT_EQ(tally.curves.size(), 2u);
  for (const CurveTally& curve : tally.curves) {
    EXPECT_EQ(curve.smallest_n, 16);
    EXPECT_EQ(curve.largest_n, 128);
  }
  const CurveTally& peer = tally.curves[1];
  EXPECT_EQ(peer.count(RunStatus::measured), 12u);
  EXPECT_EQ(peer.key.algorithm, "peer");
  EXPECT_EQ(peer.sizes.at(16).drawn, 3u);
  EXPECT_TRUE(std::isfinite(peer.sizes.at(16).mean_log(Quantity::wall_s, false)));
  EXPECT_FALSE(std::isfinite(peer.sizes.at(16).mean_log(Quantity::longest_side, false)))
      << "decimals have no unit";
  EXPECT_EQ(peer.violations, 0u);
  EXPECT_EQ(peer.unproved, 0u);
  EXPECT_TRUE(std::isnan(peer.axes[0].worst_slack));
  const std::string page = report_of(results);
  EXPECT_NE(page.find("measured, not judged"), std::string::npos);
}

/// Rows of one curve.
Results made_rows(std::size_t count) {
  Results results;
  for (std::size_t row = 0; row < count; ++row) {
    results.runs.push_back(good_run("diamond", "cubic", 64, static_cast<std::int64_t>(row)));
    results.runs[row].extents[0] = 100 + static_cast<std::int64_t>(row * 7919 % 100);
    if (row == 12345) results.runs[row].extents[0] = 300;  // of 341: the closest to the bound
  }
  return results;
}

TEST(Tally, KeepsASampleOfVeryManyGraphsAndCountsAll) {
  const std::size_t count = 30000;
  const Results rows = made_rows(count);
  const CheckVerdict verdict = ar3d::check(rows);
  EXPECT_EQ(verdict.exit_code(), 0);
  const StudyTally tally = ar3d::tally_of(rows, verdict.is_last_repetition);
  EXPECT_EQ(tally.kept_graphs, 4096u);
  const SizeTally& size = tally.curves.at(0).sizes.at(64);
  EXPECT_EQ(size.drawn, count);
  EXPECT_EQ(size.graphs.size(), 4096u);
  EXPECT_EQ(tally.curves[0].axes[0].worst.row, 12345u);
  EXPECT_EQ(size.closest.row, 12345u);
  // The mean is of all graphs; the median is that of the sample, whose error is known.
  double sum = 0;
  std::vector<double> extents, kept;
  for (std::size_t row = 0; row < count; ++row) {
    extents.push_back(static_cast<double>(rows.runs[row].extents[0]));
    sum += std::log(extents.back());
  }
  for (const DrawnGraph& graph : size.graphs) {
    kept.push_back(static_cast<double>(graph.extents[0]));
  }
  EXPECT_NEAR(size.mean_log(Quantity::extent_x, false), sum / static_cast<double>(count), 1e-12);
  EXPECT_NEAR(median(kept), median(extents), 5) << "of values from 100 to 199";
  EXPECT_TRUE(
      std::is_sorted(size.graphs.begin(), size.graphs.end(),
                     [](const DrawnGraph& a, const DrawnGraph& b) { return a.row < b.row; }));
}

TEST(Tally, SamplesHaveTheMeansOfAllInTheirFits) {
  const Results rows = made_rows(10000);
  const StudyTally tally = ar3d::tally_of(rows, ar3d::check(rows).is_last_repetition);
  const std::vector<SizeSample> sizes = samples(tally.curves[0], Quantity::extent_x);
  ASSERT_EQ(sizes.size(), 1u);
  EXPECT_EQ(sizes[0].instances.size(), 4096u);
  EXPECT_DOUBLE_EQ(sizes[0].mean_log(),
                   tally.curves[0].sizes.at(64).mean_log(Quantity::extent_x, false));
}

// No family makes the graphs of a file: such a row is shown by replay.
TEST(Check, RowsOfGraphFilesAreShownByReplay) {
  Results results = good_results({"diamond"}, {"cubic", "nets"}, 2, 1);
  results.tables.push_back(
      side_table<GraphFileRecord>({{"nets", 0, 2, std::string(32, 'a'), "/nets.s6"}}));
  results.runs[1].status = results.runs[3].status = RunStatus::timeout;
  const CheckVerdict verdict = check(results);
  EXPECT_EQ(verdict.findings.at(0).command.substr(0, 20), "ar3d generate cubic ");
  EXPECT_EQ(verdict.findings.at(1).command, "ar3d replay RESULTS.h5 3");
  EXPECT_EQ(report_of(results).find("ar3d generate nets"), std::string::npos);
  const std::string csv = bounds_csv(analyse(Rows(results)));
  EXPECT_NE(csv.find("ar3d replay RESULTS.h5 2"), std::string::npos);
  EXPECT_EQ(csv.find("ar3d generate nets"), std::string::npos);
}

TEST(Check, KeepsTheFirstFindingsAndCountsAll) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 1000);
  for (ar3d::RunRecord& run : results.runs) run.status = RunStatus::timeout;
  results.runs[2500].status = RunStatus::violated;
  const CheckVerdict verdict = check(results);
  EXPECT_EQ(verdict.exit_code(), 4);
  EXPECT_EQ(verdict.violated_rows, 1u);
  EXPECT_EQ(verdict.incomplete_rows, 2999u);
  EXPECT_EQ(verdict.all_findings, 3000u);
  EXPECT_EQ(verdict.findings.size(), 1001u);
  EXPECT_EQ(verdict.findings.front().row, 2500u);
  EXPECT_NE(summary(verdict, 2).find("… and 2998 more findings"), std::string::npos);
}

}  // namespace
}  // namespace ar3d::testing
