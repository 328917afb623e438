// Statements of the report: about programs without a theorem, crossings, commands, times.
#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/synthetic.h"
#include "ar3d/analysis/report/sections.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d::testing {
namespace {

/// Volumes of n^3 by grid and 2^6.5 n^2 lattice points by diamond, which cross at n = 2^6.5.
Results crossing_results(std::int64_t graphs_of_a_size) {
  Results results = good_results({"diamond", "grid"}, {"cubic"}, 9, graphs_of_a_size);
  for (ar3d::RunRecord& run : results.runs) {
    const double log_n = std::log2(static_cast<double>(run.n));
    run.log2_volume = run.algorithm == "grid" ? 3 * log_n : 6.5 + 2 * log_n;
  }
  return results;
}

TEST(Report, CrossingsOfVolumesAreTold) {
  const auto tables = tables_of(crossing_results(3));
  ASSERT_EQ(tables["crossings"].size(), 1u);
  const auto crossing = tables["crossings"][0];
  EXPECT_EQ(tables["settings"][crossing["below"].get<std::size_t>()]["setting"], "diamond");
  EXPECT_EQ(tables["settings"][crossing["above"].get<std::size_t>()]["setting"], "grid");
  EXPECT_EQ(crossing["n"], 91);
  EXPECT_EQ(crossing["graphs"], 18);
  EXPECT_EQ(crossing["smaller"], 18);
}

TEST(Report, CrossingsOfFewGraphsOrOfDifferentOnesAreNotTold) {
  EXPECT_EQ(tables_of(crossing_results(2))["crossings"].size(), 0u) << "six graphs below it";
  Results others = crossing_results(3);
  for (ar3d::RunRecord& run : others.runs) run.instance_index += run.algorithm == "grid" ? 100 : 0;
  EXPECT_EQ(tables_of(others)["crossings"].size(), 0u);
}

TEST(Report, PrintedCommandsNameTheFile) {
  Results results = good_results({"diamond"}, {"nets"}, 2, 1);
  results.tables.push_back(
      side_table<GraphFileRecord>({{"nets", 0, 2, std::string(32, 'a'), "/nets.s6"}}));
  results.runs[1].status = RunStatus::timeout;
  Rows rows(results);
  rows.file = "out/my runs.h5";
  const StudyAnalysis analysis = analyse(rows);
  EXPECT_EQ(analysis.verdict.findings.at(0).command, "ar3d replay 'out/my runs.h5' 1");
  EXPECT_EQ(rows_by_table(report_tables(analysis, {}, {}, false))["study"][0]["file"],
            "out/my runs.h5");
  results.runs[1].row_key = "00ff";
  EXPECT_EQ(check(results).findings.at(0).command, "ar3d replay RESULTS.h5 00ff");
}

/// `peer` draws beside `grid` with a box of 2^10 of its own units: 2^6 of vertex distances.
Results with_program(RunStatus status) {
  Results results = good_results({"grid", "peer"}, {"cubic"}, 4, 3);
  const AxisBound any{0, 1, 0, std::int64_t{1} << 61};
  std::vector<AlgorithmRecord> records = side_records<AlgorithmRecord>(results);
  records.at(1).theorem = {"integers", "at most 2^61", {any, any, any}};
  results.tables = {side_table<AlgorithmRecord>(records)};
  DrawingSummary summary;
  summary.log2_relative_volume = 6;
  ar3d::RunRecord measured;
  set_metrics(summary, measured);
  for (ar3d::RunRecord& run : results.runs) {
    if (run.algorithm == "peer") run.theorem_bound = {0x1p61, 0x1p61, 0x1p61};
    if (run.algorithm == "peer") run.status = status;
    if (run.algorithm == "peer") run.bends = {2 * run.n, 0, 0, 0, 0, 0, 0, 0};
    if (run.algorithm == "peer") run.log2_volume = 10;
    run.other_metrics = measured.other_metrics;
  }
  return results;
}

TEST(Report, VolumesOfProgramsAreComparedInOneUnit) {
  for (const RunStatus status : {RunStatus::measured, RunStatus::ok}) {
    const auto tables = tables_of(with_program(status));
    EXPECT_EQ(tables["groups"][0]["unit"], "cubes of the smallest vertex distance");
    const auto there = rows_with(tables["trade"], "n", 16);
    ASSERT_EQ(there.size(), 2u);
    for (const auto& point : there) EXPECT_NEAR(point["volume"], 64, 1e-6);
    EXPECT_EQ(there[1]["bends"], 0);
  }
}

TEST(Report, ProgramsHaveNoTheorem) {
  const Results results = with_program(RunStatus::ok);
  const auto tables = tables_of(results);
  EXPECT_GT(tables["settings"][0]["share"], 0);
  EXPECT_EQ(tables["settings"][0]["closest_family"], "cubic");
  EXPECT_EQ(tables["settings"][1]["share"], nullptr);
  EXPECT_EQ(tables["settings"][1]["theorem"], "");
  EXPECT_EQ(tables["settings"][1]["own_unit"], true);
  for (const auto& row : rows_with(tables["figures"], "setting", 1)) {
    EXPECT_EQ(row["beyond"], nullptr);
  }
  EXPECT_EQ(rows_with(tables["bound_lines"], "setting", 1).size(), 0u);
  for (const auto& row : tables["exponents"]) EXPECT_GT(row["order"], 0);
  EXPECT_TRUE(std::isnan(curves_of(results).at(1).axes[0].worst_slack));
}

TEST(Report, EveryFamilyHasANumberInTheHeatMap) {
  std::vector<std::string> families;
  for (int i = 0; i < 40; ++i) families.push_back("net-" + std::to_string(i));
  Results results = good_results({"diamond"}, families, 1, 1);
  for (std::size_t i = 0; i < 40; ++i) {
    results.runs[i] = good_run("diamond", families[i], static_cast<std::int64_t>(10 + i), 0);
  }
  const auto shares = tables_of(results)["shares"];
  EXPECT_EQ(shares.size(), 40u);
  std::set<std::int64_t> bins;
  for (const auto& row : shares) bins.insert(row["first_n"].get<std::int64_t>());
  EXPECT_LE(bins.size(), 16u);
  EXPECT_EQ(rows_with(shares, "first_n", 45).at(0)["last_n"], 49);
}

/// Two families that make other n of the sizes asked for, one of them far from 10: as
/// random-cubic-bridges does with 30 bridges.
Results results_off_the_sizes() {
  Results results = good_results({"diamond", "grid"}, {"cubic", "bridges"}, 9, 2);
  for (ar3d::RunRecord& run : results.runs) {
    run.requested_n = run.n;
    const std::int64_t n =
        run.family == "cubic" ? run.n - 1 : std::max<std::int64_t>(184, run.n + 3);
    const std::int64_t asked = run.requested_n, instance = run.instance_index;
    run = good_run(run.algorithm, run.family, n, instance);
    run.requested_n = asked;
  }
  return results;
}

TEST(Report, EveryCellAndPointHasARowOfItsN) {
  const Results results = results_off_the_sizes();
  const auto tables = tables_of(timed(results));
  std::set<std::int64_t> all_n;
  for (const ar3d::RunRecord& run : results.runs) all_n.insert(run.n);
  ASSERT_EQ(tables["shares"].size(), 2u * (9 + 5));  // 184 and 259 stand together near 256
  for (const auto& cell : tables["shares"]) {
    const ar3d::RunRecord& run = results.runs[cell["row"].get<std::size_t>()];
    EXPECT_TRUE(run.n >= cell["first_n"] && run.n <= cell["last_n"]) << cell;
    EXPECT_TRUE(all_n.contains(cell["first_n"]) && all_n.contains(cell["last_n"])) << cell;
  }
  for (const char* table : {"curves", "bands", "trade", "volume_bands", "bends_by_n"}) {
    for (const auto& row : tables[table]) EXPECT_TRUE(all_n.contains(row["n"])) << table << row;
  }
  for (const char* table : {"bands", "trade"}) {
    for (const auto& row : tables[table]) {
      EXPECT_TRUE(row["first_n"] <= row["n"] && row["n"] <= row["last_n"]) << table << row;
    }
  }
  for (const auto& row : tables["curves"]) {
    EXPECT_EQ(row["n"], results.runs[row["row"].get<std::size_t>()].n);
  }
}

TEST(Report, TheFigureOfTheSidesShowsTheShareOfTheFirstScreen) {
  Results results = good_results({"diamond"}, {"cubic", "cycle"}, 5, 1);
  for (ar3d::RunRecord& run : results.runs) {  // z is the longest, x the nearest to its bound
    run.extents = {5 * run.n, run.n, run.family == "cubic" ? 6 * run.n : run.n};
  }
  const auto tables = tables_of(results);
  double share = 0;
  for (const auto& row : rows_with(tables["curves"], "quantity", "x extent")) {
    share = std::max(share, row["largest"].get<double>() / row["bound"].get<double>());
  }
  EXPECT_NEAR(share, tables["settings"][0]["share"], 1e-4);
  EXPECT_EQ(tables["settings"][0]["closest_axis"], "x");
  EXPECT_EQ(rows_with(tables["curves"], "quantity", "z extent").size(), 0u);
}

TEST(Tables, NothingIsRoundedTwice) {
  const Table table{
      "t", "r", {{"a", "number", "", "m", 4}}, {0.874976, 0.8749500001, 1.0, 0.125, 0.62496}};
  const auto rows = rows_by_table(std::vector<Table>{table})["t"];
  const double shown[] = {0.874976, 0.87495000, 1, 0.125, 0.62496};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(std::round(1000 * rows[i]["a"].get<double>()),
              std::round(1000 * std::stod(table.cells[i].csv())));
    EXPECT_EQ(std::round(100 * rows[i]["a"].get<double>()), std::round(100 * shown[i]));
  }
}

TEST(Bins, OfSizesAreEvenOnALogarithmicScale) {
  using report::size_bins;
  using Bins = std::vector<report::SizeBin>;
  EXPECT_EQ(size_bins({10, 11, 99, 1000}, 4),
            (Bins{{10, 10, 10}, {11, 11, 11}, {99, 99, 99}, {1000, 1000, 1000}}));
  EXPECT_EQ(size_bins({10, 11, 99, 100, 999, 1000}, 2), (Bins{{10, 99, 11}, {100, 1000, 999}}));
  EXPECT_EQ(size_bins({0, 1, 2, 1000}, 3), (Bins{{0, 2, 2}, {1000, 1000, 1000}}));
  EXPECT_EQ(size_bins({}, 3), Bins{});
}

TEST(Tables, CellsAsJsonAndCsv) {
  const Table table{"t",
                    "r",
                    {{"a", "text"}, {"b", "number", "", "m", 3}, {"c", "flag", "", "m", 0, false}},
                    {"x\"</script>\xff,", 1.23456, true, {}, kMissing, false}};
  EXPECT_THAT(tables_json({table}),
              HasSubstr("[\"x\\\"\\u003c/script\\u003e\\ufffd,\",1.23,true],\n[null,null,false]"));
  EXPECT_EQ(table_csv(table), "a,b\r\n\"x\"\"</script>\xEF\xBF\xBD,\",1.23456\r\n,\r\n");
  EXPECT_EQ(table.size(), 2u);
}

}  // namespace
}  // namespace ar3d::testing
