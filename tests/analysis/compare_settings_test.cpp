// One line for each setting, and settings of one file that took turns.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ar3d/analysis/compare/compare.h"
#include "synthetic.h"

namespace ar3d::testing {
namespace {

using Row = RunRecord;  // within a test, RunRecord is gtest's

std::size_t lines_with(const std::string& text, const std::string& part) {
  std::size_t lines = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines += line.find(part) != std::string::npos;
  return lines;
}

TEST(CompareSettings, ASlowerSettingIsSaidInOneLineFirstAndInTenAtMost) {
  Results now = results_of(15, 2);
  for (Row& run : now.runs) {
    if (run.algorithm == "grid") run.wall_s *= 1.447;
  }
  const Comparison comparison = compare(results_of(15, 1), now);
  const std::string text = summary(comparison, {});
  EXPECT_THAT(text,
              StartsWith("REGRESSED    grid                         100 of 100 cells: slower; "
                         "time +44."));
  EXPECT_LE(lines_with(text, "grid"), kLinesOfCause + 1) << "the sentence of all, too\n" << text;
  const std::string markdown = comparison_markdown(comparison, {});
  EXPECT_THAT(markdown, StartsWith("## ar3d compare: REGRESSED\n\n- **REGRESSED** `grid`: 100 of "
                                   "100 cells: slower; time +44."));
  EXPECT_LT(lines_with(markdown.substr(0, markdown.find("<details>")), ""), 10u) << markdown;
  EXPECT_LE(lines_with(markdown, "grid"), kLinesOfCause + 1) << markdown;
  const auto json = nlohmann::json::parse(comparison_json(comparison, {}));
  EXPECT_EQ(json.at("settings")[0].at("setting"), "grid");
  EXPECT_LT(json.at("settings")[0].at("time_ratio_low"), json.at("settings")[0].at("time_ratio"));
  EXPECT_TRUE(json.at("cells")[0].at("time").at("p_value").is_null()) << "nothing was tested";
}

/// 40 rounds of `grid` and of `b` in turns. @param slower  what `b` takes longer.
Results turns_of(double slower, std::uint64_t seed) {
  Results results = timed(results_of(40, seed));
  std::erase_if(results.runs, [](const Row& run) { return run.algorithm != "grid"; });
  const std::vector<Row> rows = results.runs;
  RandomStream random(seed);
  for (Row run : rows) {
    run.algorithm = "b";
    run.wall_s *= (1 + slower) * std::exp(0.05 * normal(random));
    results.runs.push_back(run);
  }
  results.environment.push_back({kTimingOrder, "in turns", 0});
  return results;
}

const std::vector<SettingPair> kPair = {{"grid -> b", {"grid", "", {}, {}}, {"b", "", {}, {}}}};

TEST(CompareSettings, SettingsOfOneFileAreJudgedByTheirTurns) {
  EXPECT_EQ(compare_settings(turns_of(0, 1), kPair).word(), "PASS");
  const Comparison slower = compare_settings(turns_of(0.2, 2), kPair);
  EXPECT_EQ(slower.word(), "REGRESSED");
  EXPECT_EQ(slower.settings.at(0).pairs, 40u);
  EXPECT_NEAR(std::exp(slower.settings.at(0).change), 1.2, 0.02);
  EXPECT_LT(slower.settings.at(0).error, 0.02);
  EXPECT_LT(slower.settings.at(0).visible, 0.1);
  Results not_in_turns = turns_of(0.2, 2);
  not_in_turns.environment.pop_back();
  const Comparison drawings = compare_settings(not_in_turns, kPair);
  EXPECT_EQ(drawings.word(), "DRAWINGS PASS");
  EXPECT_THAT(drawings.remarks, Contains(HasSubstr("no times that were taken in turns")));
  Results larger = turns_of(0, 1);
  larger.runs.back().extents[0] += 1;
  EXPECT_EQ(compare_settings(larger, kPair).exit_code(), 3);
}

/// A cell whose rounds leave it open follows its setting, unless they show that it moved otherwise.
TEST(CompareSettings, AnOpenCellFollowsItsSetting) {
  const auto with_noise = [](double slower, double of_first) {
    Results results = turns_of(slower, 3);
    RandomStream random(4);
    for (Row& run : results.runs) {
      if (run.family != "family0" || run.n != 16) continue;
      run.wall_s *= std::exp(0.15 * normal(random)) * (run.algorithm == "b" ? of_first : 1);
    }
    return compare_settings(results, kPair);
  };
  const Comparison alike = with_noise(0, 1);
  EXPECT_GT(std::exp(alike.cells.at(0).time.interval.high), 1.05) << "open by itself";
  EXPECT_EQ(alike.cells.at(0).verdict, Verdict::pass) << alike.cells.at(0).reason;
  EXPECT_EQ(alike.word(), "PASS");
  EXPECT_GT(alike.settings.at(0).visible_alone, 2 * alike.settings.at(0).visible);
  EXPECT_THAT(summary(alike, {}), HasSubstr("; in one cell alone it shows from "));
  const Comparison other = with_noise(0.3, 1 / 1.3);
  EXPECT_EQ(other.cells.at(0).verdict, Verdict::inconclusive) << other.cells.at(0).reason;
  EXPECT_EQ(other.settings.at(0).of_verdict, other.cells.size() - 1);
  EXPECT_THAT(summary(other, {}), HasSubstr("40 rounds show changes from "));
}

TEST(CompareSettings, WhatCameOutOnNeitherSideIsNoPass) {
  Results base = results_of(15, 1);
  base.runs[3].status = RunStatus::crashed;
  base.runs[3].message = "ended with code 3";
  Results now = base;
  now.runs[3].wall_s *= 1.01;
  const Comparison comparison = compare(base, now);
  EXPECT_EQ(comparison.exit_code(), 5);
  EXPECT_THAT(comparison.incomplete.at(0),
              HasSubstr("came out on neither side: ended with code 3"));
}

}  // namespace
}  // namespace ar3d::testing
