// Statements of the report: about programs without a theorem, crossings, commands, times.
#include <algorithm>
#include <cmath>

#include "analysis/synthetic.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d::testing {
namespace {

std::size_t parts_in(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// Volumes of n^3 by grid and 2^6.5 n^2 lattice points by diamond, which cross at n = 2^6.5.
Results crossing_results(std::int64_t graphs_of_a_size) {
  Results results = good_results({"diamond", "grid"}, {"cubic"}, 9, graphs_of_a_size);
  for (ar3d::RunRecord& run : results.runs) {
    const double log_n = std::log2(static_cast<double>(run.n));
    run.log2_volume = run.algorithm == "grid" ? 3 * log_n : 6.5 + 2 * log_n;
  }
  return results;
}

TEST(Report, CrossingsOfVolumesAreMarkedAndTold) {
  const std::string html = report_of(crossing_results(3));
  EXPECT_EQ(parts_in(html, "class='crossing'"), 1u);
  EXPECT_THAT(html, HasSubstr("diamond needs less volume than grid from about n = 91 on (there 18 "
                              "of 18 graphs that both drew)"));
}

TEST(Report, CrossingsOfFewGraphsOrOfDifferentOnesAreNotTold) {
  EXPECT_THAT(report_of(crossing_results(2)), Not(HasSubstr("needs less volume")))
      << "six graphs below it";
  Results others = crossing_results(3);
  for (ar3d::RunRecord& run : others.runs) run.instance_index += run.algorithm == "grid" ? 100 : 0;
  EXPECT_THAT(report_of(others), Not(HasSubstr("needs less volume")));
}

TEST(Report, PrintedCommandsNameTheFile) {
  Results results = good_results({"diamond"}, {"nets"}, 2, 1);
  results.tables.push_back(graph_file_table({{"nets", 0, 2, std::string(32, 'a'), "/nets.s6"}}));
  results.runs[1].status = RunStatus::timeout;
  RowView rows = view_of(results);
  rows.file = "out/my runs.h5";
  const StudyAnalysis analysis = analyse(rows);
  EXPECT_EQ(analysis.verdict.findings.at(0).command, "ar3d replay 'out/my runs.h5' 1");
  EXPECT_THAT(render_report(analysis), HasSubstr("ar3d replay 'out/my runs.h5' "));
}

/// `peer` draws beside `grid` with a box of 2^10 of its own units: 2^6 of vertex distances.
Results with_program(RunStatus status) {
  Results results = good_results({"grid", "peer"}, {"cubic"}, 4, 3);
  const AxisBound any{0, 1, 0, std::int64_t{1} << 61};
  std::vector<AlgorithmRecord> records = algorithm_records(results);
  records.at(1).theorem = {"integers", "at most 2^61", {any, any, any}};
  results.tables = {algorithm_table(records)};
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
    const Results results = with_program(status);
    const StudyAnalysis analysis = analyse(view_of(results));
    const std::vector<Figure> figures = report_figures(analysis);
    const auto trade = std::ranges::find(figures, "trade-n-16", &Figure::name);
    ASSERT_NE(trade, figures.end());
    EXPECT_THAT(trade->csv, HasSubstr(",grid,point,"));
    EXPECT_EQ(parts_in(trade->csv, ",64,,\r\n"), 3u) << "two points and a front, 2^6 each";
    const std::string html = render_report(analysis);
    EXPECT_THAT(html, HasSubstr("volume in cubes of the smallest vertex distance"));
    EXPECT_THAT(html, HasSubstr("</svg>straight edges</span>"));
    EXPECT_THAT(html, Not(HasSubstr("at most 2 bends")));
  }
}

TEST(Report, ProgramsHaveNoTheorem) {
  const Results results = with_program(RunStatus::ok);
  const StudyAnalysis analysis = analyse(view_of(results));
  const std::string html = render_report(analysis);
  const std::size_t peer = html.find("<section id=a1 ");
  const std::string section = html.substr(peer, html.find("</section>", peer) - peer);
  EXPECT_THAT(html, HasSubstr("closest to a bound is <button type=button class=graph data-r="));
  EXPECT_THAT(html, HasSubstr(">grid on cubic"));
  EXPECT_THAT(section, Not(HasSubstr("Theorem&#39;s box")));
  EXPECT_THAT(section, Not(HasSubstr("times above")));
  EXPECT_THAT(html, Not(HasSubstr("n^0")));
  EXPECT_TRUE(std::isnan(analysis.bounds.at(1).axes[0].worst_slack));
}

TEST(Report, UntimedDrawingsAreCalledUntimed) {
  const std::string html = report_of(good_results({"diamond"}, {"cubic"}, 3, 2));
  EXPECT_THAT(html, HasSubstr("not timed <small><code>timed_repetitions</code>"));
  EXPECT_THAT(html, HasSubstr("<td class=num>not timed</td></tr>")) << "in the first table";
  EXPECT_THAT(html, Not(HasSubstr("no finished size")));
}

TEST(Report, EveryFamilyHasANumberInTheHeatMap) {
  std::vector<std::string> families;
  for (int i = 0; i < 40; ++i) families.push_back("net-" + std::to_string(i));
  Results results = good_results({"diamond"}, families, 1, 1);
  for (std::size_t i = 0; i < 40; ++i) {
    results.runs[i] = good_run("diamond", families[i], static_cast<std::int64_t>(10 + i), 0);
  }
  const std::string html = report_of(results);
  const std::size_t heat = html.find("<table class='heat");
  const std::string table = html.substr(heat, html.find("</table>", heat) - heat);
  EXPECT_EQ(parts_in(table, " data-r="), 40u) << "40 sizes in 16 columns";
  EXPECT_THAT(table, HasSubstr("title='n = 45 – 49'"));
}

}  // namespace
}  // namespace ar3d::testing
