// What a report says of drawings in real types, of certificate modes and of levels; the statistics
// of real types are the page's (tests/browser/precision.test.mjs).
#include <memory>

#include "analysis/synthetic.h"
#include "ar3d/analysis/report/report.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d::testing {
namespace {

/// A drawing whose condition is n^2.
RunRecord real_run(int type, std::int64_t n, std::int64_t instance, const std::string& family,
                   double miss, std::int64_t collapsed = 0) {
  RunRecord run = good_run("two-bend-paper", family, n, instance);
  run.options = "type=" + std::to_string(type);
  run.certificate = "measured";
  run.theorem_bound = {kMissing, kMissing, kMissing};
  auto real = std::make_shared<RealAssessment>();
  real->angles = 4;
  real->condition = static_cast<double>(n) * static_cast<double>(n);
  real->largest_miss = miss;
  real->within = {1, 2, 3, 4};
  real->collapsed = collapsed;
  DrawingSummary summary;
  summary.real = std::move(real);
  set_metrics(summary, run);
  return run;
}

TEST(PrecisionReport, HoldsEveryDrawingInARealType) {
  Results results = good_results({}, {}, 0, 0);
  for (const char* family : {"cycle", "prism"}) {
    for (int type = 0; type < 5; ++type) {
      results.runs.push_back(real_run(type, 16, 0, family, 1e-6));
      results.runs.push_back(real_run(type, 16, 1, family, 0, type == 0));
    }
  }
  results.runs.push_back(real_run(3, 32, 0, "prism", 2));
  results.runs.back().status = RunStatus::measured;  // as of a program of one's own
  const auto all = timed(results);
  const auto tables = tables_of(all);
  EXPECT_EQ(tables["precision"][0]["drawings"], 21);
  EXPECT_EQ(tables["precision"][0]["left_out"], 0);
  ASSERT_EQ(tables["real_drawings"].size(), 21u) << "none of the timing phase";
  EXPECT_EQ(rows_with(tables["real_drawings"], "broken", true).size(), 2u);
  EXPECT_EQ(rows_with(tables["real_drawings"], "miss", 0).size(), 10u) << "they miss nothing";
  const auto last = tables["real_drawings"][20];
  EXPECT_EQ(last["miss"], 2);
  EXPECT_EQ(last["condition"], 1024);
  EXPECT_EQ(last["within_1e_12"], 0.25);
  EXPECT_EQ(last["within_1e_3"], 1);
  const auto curve = tables["bounds"][last["curve"].get<std::size_t>()];
  EXPECT_EQ(curve["options"], "type=3");
  EXPECT_EQ(curve["family"], "prism");
  const auto graphs = rows_with(tables["graphs"], "row", last["row"]);
  ASSERT_EQ(graphs.size(), 1u) << "the family with most drawings has its graphs there";
  EXPECT_NEAR(graphs[0]["seconds"], results.runs.back().wall_s, 1e-9);
}

TEST(PrecisionReport, CertificateModesAndLevels) {
  Results results = good_results({"diamond"}, {"cubic"}, 2, 3);
  EXPECT_EQ(tables_of(results)["judgements"].size(), 0u);
  EXPECT_EQ(tables_of(results)["precision"].size(), 0u);
  const std::size_t exact = results.runs.size();
  for (std::size_t i = 0; i < exact; ++i) {
    RunRecord run = results.runs[i];
    run.certificate = "filtered";
    run.certify_s = 32e-6;
    run.instance_index += 10;
    run.graph_hash += "f";
    results.runs.push_back(run);
  }
  const auto filtered =
      rows_with(tables_of(results)["judgements"], "certificate", "filtered").at(0);
  EXPECT_EQ(filtered["rows"], 3);
  EXPECT_NEAR(filtered["certify"], 2e-6, 1e-12);
  EXPECT_EQ(filtered["has_levels"], false);

  results = good_results({"diamond"}, {"cubic"}, 2, 3);
  for (std::size_t i = 0; i < exact; ++i) {
    RunRecord run = results.runs[i];
    run.level = "full";
    run.store_s = 16e-6;
    run.peak_scope = "worker";
    run.base_bytes = 1000;
    run.peak_bytes = 1000 + 100 * run.n;
    results.runs.push_back(run);
  }
  const auto full = rows_with(tables_of(results)["judgements"], "level", "full").at(0);
  EXPECT_EQ(full["has_levels"], true);
  EXPECT_EQ(full["rows"], 3);
  EXPECT_EQ(full["bytes"], 100);
}

TEST(PrecisionReport, EffortsAreComparedWithTheFirst) {
  Results results = good_results({"diamond"}, {"cubic"}, 2, 3);
  const std::size_t first = results.runs.size();
  for (std::size_t i = 0; i < first; ++i) {
    results.runs[i].options = "effort=0";
    RunRecord run = results.runs[i];
    run.options = "effort=1";
    run.wall_s *= 10;
    run.log2_volume -= 1;
    results.runs.push_back(run);
    run = results.runs[i];
    run.level = "full";
    results.runs.push_back(run);
  }
  const auto untimed = tables_of(results)["efforts"],
             efforts = tables_of(timed(results))["efforts"];
  ASSERT_EQ(efforts.size(), 2u);
  EXPECT_NEAR(efforts[1]["time"], 10, 1e-3);
  EXPECT_NEAR(efforts[1]["volume"], 0.5, 1e-4);
  EXPECT_EQ(untimed[1]["time"], nullptr) << "no timing phase";
}

}  // namespace
}  // namespace ar3d::testing
