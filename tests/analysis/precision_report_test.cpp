// What a report says of drawings in real types, of certificate modes and of levels.
#include <cmath>
#include <limits>
#include <memory>

#include "analysis/synthetic.h"
#include "ar3d/analysis/report.h"
#include "ar3d/analysis/report/precision.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d::testing {
namespace {

using report::judge_onset;
using report::OnsetVerdict;

constexpr int kBits[] = {24, 53, 64, 113, 237};
constexpr double kDegrees = 57.29577951308232;

/// A drawing whose condition is n^2 and whose miss is `kappa` of what that allows.
RunRecord real_run(int type, std::int64_t n, std::int64_t instance, double kappa,
                   const std::string& family = "random-cubic") {
  RunRecord run = good_run("two-bend-paper", family, n, instance);
  run.options = "type=" + std::to_string(type);
  run.certificate = "measured";
  run.theorem_bound = {kMissing, kMissing, kMissing};
  run.cpu_s = 1e-6 * static_cast<double>(n) * (type + 1);
  auto real = std::make_shared<RealAssessment>();
  real->angles = 4;
  real->condition = static_cast<double>(n) * static_cast<double>(n);
  real->largest_miss = kappa * kDegrees * std::ldexp(real->condition, -kBits[type]);
  real->within = {1, 2, 3, 4};
  DrawingSummary summary;
  summary.real = std::move(real);
  set_metrics(summary, run);
  return run;
}

/// Five types, n = 16, 32, …, 4096, three graphs each; kappa of one type as told, else 0.2.
Results real_results(int other_type = -1, double other_kappa = 0.2) {
  Results results = good_results({}, {}, 0, 0);
  for (std::int64_t n = 16; n <= 4096; n *= 2) {
    for (int type = 0; type < 5; ++type) {
      for (std::int64_t i = 0; i < 3; ++i) {
        results.runs.push_back(real_run(type, n, i, type == other_type ? other_kappa : 0.2));
      }
    }
  }
  return results;
}

/// The onset of a type on the sample family.
nlohmann::json onset_of(const nlohmann::json& tables, std::size_t type, double limit) {
  for (const auto& row : rows_with(tables["onsets"], "type", type)) {
    if (std::abs(row["limit"].get<double>() / limit - 1) < 1e-6) return row;
  }
  return {};
}

TEST(PrecisionReport, PredictsEveryTypeFromTheWidest) {
  const auto tables = tables_of(real_results());
  const auto about = tables["precision"][0];
  EXPECT_EQ(about["drawings"], 135);
  EXPECT_EQ(about["broken"], 0);
  EXPECT_EQ(about["model"], "237 bits");
  EXPECT_EQ(about["predictors"], 27);
  EXPECT_NEAR(about["kappa"], 0.2, 1e-6);
  EXPECT_EQ(about["refuted"], 0);
  // 0.2 * 57.3 * 2^-24 n^2 = 10^-3 at n = 38; 10^-9 in double at n = 886.
  const auto single = onset_of(tables, 0, 1e-3), twice = onset_of(tables, 1, 1e-9);
  EXPECT_EQ(single["seen"], 38);
  EXPECT_EQ(single["predicted"], 38);
  EXPECT_EQ(single["verdict"], "confirmed");
  EXPECT_EQ(twice["seen"], 887);
  EXPECT_EQ(twice["predicted"], 887);
  EXPECT_EQ(tables["misses"].size(), 135u);
  EXPECT_EQ(tables["miss_medians"].size(), 5u * 9);
  EXPECT_EQ(tables["predicted_misses"].size(), 9u);
  EXPECT_EQ(rows_with(tables["accuracies"], "time", nullptr).size(), tables["accuracies"].size())
      << "no timing phase";
  for (const auto& row : tables["miss_shares"]) {
    EXPECT_NEAR(row["within_1e_12"], 0.25, 1e-9) << "one of four angles";
    EXPECT_EQ(row["all_1e_12"], 0);
    EXPECT_EQ(row["all_1e_3"], 1);
  }
}

TEST(PrecisionReport, SaysWhichPredictionsAreRefuted) {
  const auto tables = tables_of(real_results(1, 0.2 * 25));
  // A miss 25 times as large passes every limit at a fifth of n.
  const auto twice = onset_of(tables, 1, 1e-9);
  EXPECT_EQ(twice["seen"], 177);
  EXPECT_EQ(twice["predicted"], 887);
  EXPECT_EQ(twice["verdict"], "refuted");
  EXPECT_NEAR(twice["kappa_seen"], 5, 1e-6);
  EXPECT_NEAR(twice["kappa"], 0.2, 1e-6);
  EXPECT_EQ(onset_of(tables, 0, 1e-3)["verdict"], "confirmed");
}

TEST(PrecisionReport, WhatLiesBeyondTheSizesIsOpenUnlessItIsFar) {
  constexpr double kBeyond = std::numeric_limits<double>::infinity();
  const auto verdict = [](double predicted, double seen) {
    return judge_onset({"f", 0, -9, predicted, seen, 1, 3, OnsetVerdict::open});
  };
  EXPECT_EQ(verdict(2, 2.3), OnsetVerdict::confirmed);
  EXPECT_EQ(verdict(2, 2.302), OnsetVerdict::refuted);
  EXPECT_EQ(verdict(2.302, 2), OnsetVerdict::refuted);
  EXPECT_EQ(verdict(kBeyond, 2.8), OnsetVerdict::open) << "less than twice as large";
  EXPECT_EQ(verdict(kBeyond, 2.6), OnsetVerdict::refuted) << "at least 2.5 times as large";
  EXPECT_EQ(verdict(2.8, kBeyond), OnsetVerdict::open);
  EXPECT_EQ(verdict(2.6, kBeyond), OnsetVerdict::refuted);
  EXPECT_EQ(verdict(-kBeyond, 1.2), OnsetVerdict::open);
  EXPECT_EQ(verdict(1.4, -kBeyond), OnsetVerdict::refuted);
  EXPECT_EQ(verdict(-kBeyond, kBeyond), OnsetVerdict::refuted);
}

TEST(PrecisionReport, DrawingsThatMissNothingAndBrokenOnes) {
  Results results = real_results();
  for (RunRecord& run : results.runs) {
    if (run.options != "type=0" || run.n > 32) continue;
    const std::int64_t n = run.n;
    run = real_run(0, n, run.instance_index, 0);
    if (n == 16) continue;
    DrawingSummary summary;
    auto real = std::make_shared<RealAssessment>();
    real->angles = 1;
    real->largest_miss = 30;
    real->condition = 1e3;
    real->collapsed = 1;
    summary.real = std::move(real);
    set_metrics(summary, run);
  }
  const auto tables = tables_of(results);
  EXPECT_EQ(tables["precision"][0]["broken"], 3);
  EXPECT_EQ(rows_with(tables["misses"], "broken", true).size(), 3u);
  EXPECT_EQ(rows_with(tables["misses"], "miss", 0).size(), 3u) << "they miss nothing";
}

TEST(PrecisionReport, OneTypeAloneIsShownAndPredictsNothing) {
  Results results = real_results();
  std::erase_if(results.runs, [](const RunRecord& run) { return run.options != "type=1"; });
  const auto tables = tables_of(results);
  EXPECT_EQ(tables["miss_medians"].size(), 9u);
  EXPECT_EQ(tables["onsets"].size(), 0u);
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

TEST(PrecisionReport, TypesAreThoseOfTheAlgorithm) {
  const auto name = [](const std::string& algorithm, const std::string& options) {
    return report::real_setting({algorithm, options, "", "", ""}).name;
  };
  EXPECT_EQ(name("two-bend-paper", "type=0"), "float");
  EXPECT_EQ(name("two-bend-paper", "type=4"), "237 bits");
  EXPECT_EQ(name("two-bend-paper", "type=5"), "two-bend-paper (type=5)");
  EXPECT_EQ(name("mine", "type=0"), "mine (type=0)");
  EXPECT_EQ(report::real_setting({"mine", "", "", "", ""}).bits, 0);
}

}  // namespace
}  // namespace ar3d::testing
