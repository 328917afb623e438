// The report of a collection: who drew how many, profiles, scatters with outliers, groups.
#include <algorithm>
#include <cmath>

#include "analysis/synthetic.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d::testing {
namespace {

constexpr std::int64_t kCollectionGraphs = 400;

/// 400 graphs of 10 to 109 vertices in two groups. `compact` needs a quarter of `diamond`'s volume,
/// but for graph 17 a thousand times as much; `grid` refuses the second half.
Results collection_results(std::int64_t graphs = kCollectionGraphs) {
  Results results = good_results({"diamond", "compact", "grid"}, {}, 0, 0);
  results.tables.push_back(
      graph_file_table({{"rome", 0, graphs, std::string(32, 'a'), "/rome/*.graphml"}}));
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

std::string section_with(const std::string& html, const std::string& id) {
  const std::size_t begin = html.find("<section id=" + id);
  return begin == std::string::npos ? ""
                                    : html.substr(begin, html.find("</section>", begin) - begin);
}

std::size_t lines_with(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

const Figure& figure_named(const std::vector<Figure>& figures, const std::string& name) {
  const auto at = std::ranges::find(figures, name, &Figure::name);
  if (at == figures.end()) throw std::runtime_error("no figure " + name);
  return *at;
}

TEST(Collection, TellsWhoDrewHowMany) {
  const std::string html = report_of(collection_results());
  EXPECT_THAT(section_with(html, "c0"),
              HasSubstr("<th scope=row>grid</th><td class=num>400</td><td class=num>200</td>"
                        "<td class=num>50.0 %</td><td class=num>200</td><td class=num>0</td>"));
  EXPECT_EQ(section_with(html, "trade"), "") << "compared graph by graph";
  EXPECT_THAT(html, HasSubstr("<a href='#c0'>"));
}

// 399 of 400 by compact are the best, grid has diamond's volumes of half the graphs.
TEST(Collection, ProfilesAreSharesOfGraphsWithinAFactorOfTheBest) {
  const Results results = collection_results();
  const std::vector<Figure> figures = report_figures(analyse(view_of(results)));
  const Figure& profile = figure_named(figures, "rome-profile-volume");
  EXPECT_THAT(profile.csv, HasSubstr(",compact,line,1,0.9975,"));
  EXPECT_THAT(profile.csv, HasSubstr(",diamond,line,1,0.0025,"));
  EXPECT_THAT(profile.csv, HasSubstr(",grid,line,1024,0.5,"));
  EXPECT_THAT(profile.csv, HasSubstr(",diamond,line,1024,1,"));
  EXPECT_THAT(profile.matplotlib, HasSubstr("set_yscale(\"linear\")"));
  EXPECT_THAT(profile.pgfplots, HasSubstr("semilogxaxis"));
}

TEST(Collection, ScattersNameTheirOutliersAndOpenThem) {
  const Results results = collection_results();
  const StudyAnalysis analysis = analyse(view_of(results));
  const std::string html = render_report(analysis);
  EXPECT_THAT(html, HasSubstr("<option value=0>Volume: compact against diamond</option>"));
  EXPECT_THAT(section_with(html, "c0"),
              HasSubstr("<li>grafo17.graphml, n = 27: × 1.02e+03 <button type=button class=graph "
                        "data-r=17>diamond</button> <button type=button class=graph "
                        "data-r=417>compact</button></li>"));
  const std::vector<std::size_t> rows = rows_to_show(analysis, 200, 1000);
  EXPECT_THAT(rows, Contains(17u));
  EXPECT_THAT(rows, Contains(417u));
}

TEST(Collection, GroupsAndBinsOfSizes) {
  const Results results = collection_results();
  const StudyAnalysis analysis = analyse(view_of(results));
  const std::string html = section_with(render_report(analysis), "c0");
  EXPECT_THAT(html, HasSubstr("<summary>Volume by group</summary>"));
  EXPECT_THAT(html, HasSubstr("<th scope=row>la&lt;rge</th><td class=num>300</td>"));
  const std::string csv = figure_named(report_figures(analysis), "rome-by-n-volume").csv;
  EXPECT_EQ(lines_with(csv, "\n"), 1u + 3 * 16) << "16 bins of 100 sizes";
  const std::string growth = figure_named(report_figures(analysis), "diamond-volume").csv;
  EXPECT_EQ(lines_with(growth, ",rome,line,"), 16u);
}

TEST(Collection, FewGraphsOfAFileAreNone) {
  EXPECT_EQ(section_with(report_of(collection_results(19)), "c0"), "");
}

// Ten thousand graphs by three algorithms.
TEST(Collection, ThePageOfManyGraphsStaysSmall) {
  EXPECT_LT(report_of(collection_results(10000)).size(), 10'000'000u);
}

}  // namespace
}  // namespace ar3d::testing
