// The report of a collection: who drew how many, profiles, scatters with outliers, groups.
#include <algorithm>
#include <cmath>

#include "analysis/synthetic.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d::testing {
namespace {

constexpr std::int64_t kCollectionGraphs = 400;

/// 400 graphs of 10 to 109 vertices in two groups. `compact` needs a quarter of `diamond`'s volume,
/// except for graph 17 a thousand times as much; `grid` refuses the second half.
Results collection_results(std::int64_t graphs = kCollectionGraphs) {
  Results results = good_results({"diamond", "compact", "grid"}, {}, 0, 0);
  results.tables.push_back(
      side_table<GraphFileRecord>({{"rome", 0, graphs, std::string(32, 'a'), "/rome/*.graphml"}}));
  for (const char* algorithm : {"diamond", "compact", "grid"}) {
    for (std::int64_t i = 0; i < graphs; ++i) {
      RunRecord run = good_run(algorithm, "rome", 10 + i % 100, i);
      run.graph_name = "grafo" + std::to_string(i) + ".graphml";
      run.group = i % 4 == 0 ? "small" : "la<rge";
      run.log2_volume = std::log2(static_cast<double>(run.n));
      if (run.algorithm == "compact") run.log2_volume += i == 17 ? 10 : -2;
      if (run.algorithm == "grid" && i >= graphs / 2) run.status = RunStatus::refused;
      results.runs.push_back(run);
    }
  }
  return results;
}

std::vector<nlohmann::json> of_volume(const nlohmann::json& rows, std::size_t setting) {
  std::vector<nlohmann::json> found;
  for (const auto& row : rows_with(rows, "measure", "volume")) {
    if (row["setting"] == setting) found.push_back(row);
  }
  return found;
}

TEST(Collection, TellsWhoDrewHowMany) {
  const auto tables = tables_of(collection_results());
  const auto grid = rows_with(tables["collections"], "setting", 2).at(0);
  EXPECT_EQ(grid["collection"], "rome");
  EXPECT_EQ(grid["graphs"], 400);
  EXPECT_EQ(grid["drawn"], 200);
  EXPECT_EQ(grid["refused"], 200);
  EXPECT_EQ(tables["groups"].size(), 0u) << "compared graph by graph";
}

// 399 of 400 by compact are the best, grid has diamond's volumes of half the graphs.
TEST(Collection, ProfilesAreSharesOfGraphsWithinAFactorOfTheBest) {
  const auto profile = tables_of(collection_results())["profile"];
  EXPECT_NEAR(of_volume(profile, 1).front()["share"], 0.9975, 1e-9);
  EXPECT_NEAR(of_volume(profile, 0).front()["share"], 0.0025, 1e-9);
  EXPECT_NEAR(of_volume(profile, 2).back()["factor"], 1024, 0.1);
  EXPECT_NEAR(of_volume(profile, 2).back()["share"], 0.5, 1e-9);
  EXPECT_NEAR(of_volume(profile, 0).back()["share"], 1, 1e-9);
  EXPECT_EQ(rows_with(profile, "measure", "drawing time").size(), 0u) << "no timing phase";
  EXPECT_GT(rows_with(tables_of(timed(collection_results()))["profile"], "measure", "drawing time")
                .size(),
            0u);
}

TEST(Collection, PairsNameTheirOutliersAndOpenThem) {
  const Results results = collection_results();
  const auto tables = tables_of(results);
  const auto outliers = rows_with(tables["pairs"], "outlier", true);
  const auto worst =
      std::ranges::find_if(outliers, [](const auto& row) { return row["row"] == 17; });
  ASSERT_NE(worst, outliers.end());
  EXPECT_EQ((*worst)["other_row"], 417);
  EXPECT_NEAR((*worst)["ratio"], 1024, 1);
  EXPECT_EQ(rows_with(tables["graphs"], "row", 17).at(0)["name"], "grafo17.graphml");
  const std::vector<std::size_t> rows = rows_to_show(analyse(ar3d::Rows(results)), 200, 1000);
  EXPECT_THAT(rows, Contains(17u));
  EXPECT_THAT(rows, Contains(417u));
}

// compact needs a quarter of diamond's volume for 399 of 400 graphs; grid as much as diamond.
TEST(Collection, TwoSettingsAreStatedTogether) {
  Results results = collection_results();
  for (RunRecord& run : results.runs) run.bends = {0, run.algorithm == "compact" ? 1 : 0};
  const auto tables = tables_of(results);
  const auto counts = of_volume(tables["pair_counts"], 0);
  const auto compact = rows_with(counts, "other", 1).at(0),
             grid = rows_with(counts, "other", 2).at(0);
  EXPECT_NEAR(compact["ratio"], 0.25, 1e-6);
  EXPECT_NEAR(compact["ratio_low"], 0.25, 1e-6);
  EXPECT_NEAR(compact["ratio_high"], 0.25, 1e-6);
  EXPECT_EQ(compact["ties"], 0);
  EXPECT_LT(compact["p"], 1e-100);
  EXPECT_EQ(grid["ties"], 200);
  EXPECT_EQ(grid["p"], 1);
  const auto common = of_volume(tables["common_profile"], 0);
  EXPECT_EQ(common.front()["graphs"], 200) << "that grid drew, too";
  const auto of_bends = rows_with(tables["group_medians"], "measure", "bends");
  EXPECT_EQ(rows_with(of_bends, "setting", 0).at(0)["median"], 0);
  EXPECT_EQ(rows_with(of_bends, "setting", 1).at(0)["median"], 1);
}

TEST(Collection, GroupsSortAsPeopleDoAndNoneIsLost) {
  Results results = collection_results(60);
  const char* kNames[] = {"C10", "", "C2", "δ", "C2b"};
  for (RunRecord& run : results.runs) run.group = kNames[run.instance_index % 5];
  std::vector<std::string> order;
  for (const auto& row : of_volume(tables_of(results)["group_medians"], 0)) {
    order.push_back(row["group"]);
  }
  EXPECT_THAT(order, ElementsAre("(no group)", "C2", "C2b", "C10", "δ"));
}

// Volumes of the group "small" are n of graphs 0, 4, …: 10, 14, …, 106; four graphs have each.
TEST(Collection, MediansOfGroupsAndBins) {
  const auto tables = tables_of(collection_results());
  const auto groups = of_volume(tables["group_medians"], 0);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0]["group"], "la<rge");
  EXPECT_EQ(groups[0]["graphs"], 300);
  EXPECT_EQ(groups[1]["graphs"], 100);
  EXPECT_NEAR(groups[1]["median"], 58, 1e-3) << "of 100 volumes between 10 and 106";
  EXPECT_EQ(of_volume(tables["bins"], 0).size(), 16u);
  EXPECT_EQ(rows_with(rows_with(tables["curves"], "quantity", "volume"), "curve", 0).size(), 16u);
}

// The median of an even number of values lies between the two middle ones.
TEST(Collection, TheMedianOfTwoValuesIsTheirMiddle) {
  Results results = collection_results(20);
  for (RunRecord& run : results.runs) {
    run.group = run.instance_index < 2 ? "two" : "";
    run.log2_volume = run.instance_index == 0 ? 3 : 5;
  }
  const auto groups = of_volume(tables_of(results)["group_medians"], 0);
  EXPECT_NEAR(rows_with(groups, "group", "two").at(0)["median"], 20, 1e-6) << "of 8 and 32";
}

TEST(Collection, FewGraphsOfAFileAreNone) {
  EXPECT_EQ(tables_of(collection_results(19))["collections"].size(), 0u);
}

// Ten thousand graphs by three algorithms.
TEST(Collection, ThePageOfManyGraphsStaysSmall) {
  EXPECT_LT(report_of(collection_results(10000)).size(), 6'000'000u);
}

}  // namespace
}  // namespace ar3d::testing
