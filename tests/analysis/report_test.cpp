#include "ar3d/analysis/report.h"

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "analysis/synthetic.h"
#include "ar3d/analysis/export.h"
#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/base/printable.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d::testing {
namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

std::string rows_json(const std::string& html) {
  const std::string start = "<script type='application/json' id=rows>";
  const std::size_t begin = html.find(start) + start.size();
  return html.substr(begin, html.find("</script>", begin) - begin);
}

Results hostile_results() {
  const std::string attack =
      "</script><script>alert(1)</script><img src=x onerror='alert(2)'>\"&\xff\x01";
  Results results = good_results({"diamond"}, {"cubic" + attack}, 9, 3);
  for (auto& run : results.runs) {
    run.algorithm += attack;
    run.options = run.parameters = run.message = run.graph_hash = run.row_key = attack;
  }
  results.runs[0].status = RunStatus::crashed;
  results.study_id = results.spec = results.spec_hash = results.source_hash = results.created =
      attack;
  results.environment = {{attack, attack}};
  return results;
}

/// True if `word` stands in the text with no letter or digit beside it.
bool has_word(const std::string& text, const std::string& word) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i])) != 0;
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    if (!(at > 0 && is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  }
  return false;
}

TEST(Report, IsOnePageThatNeedsNothingFromOutside) {
  const std::string html = report_of(good_results({"diamond", "grid"}, {"cubic"}, 9, 4));
  EXPECT_EQ(occurrences(html, "<script"), 6u)
      << "rows, figures, a style for saving, drawings, the viewer, and one script";
  EXPECT_EQ(occurrences(html, "<style"), 1u);
  for (const char* outside : {"src=http", "src='http", "src=\"http", "src=//", "href=http",
                              "href='http", "href=\"http", "href=//", "@import", "url("}) {
    EXPECT_EQ(occurrences(html, outside), 0u) << outside;
  }
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  EXPECT_THAT(html, HasSubstr(">PASS<"));
  EXPECT_EQ(occurrences(html, "<figure data-fig="), 9u + 1 + 2 * (3 + 1))
      << "the trade at nine n, volume against n, and for each setting three growths and the bends";
  EXPECT_EQ(occurrences(html, "<table class='heat sortable'>"), 2u);
  EXPECT_LT(html.size(), 2'000'000u);
}

TEST(Report, ShowsEveryMetricOfTheTableWithUnitAndDefinition) {
  const std::string html = report_of(good_results({"diamond"}, {"cubic"}, 9, 4));
  const std::size_t section = html.find("<section id=metrics>");
  ASSERT_NE(section, std::string::npos);
  for (const Metric& metric : metrics()) {
    const std::size_t row = html.find("<tr><th scope=row>" + metric.name + "</th>", section);
    ASSERT_NE(row, std::string::npos) << metric.name;
    const std::string cells = html.substr(row, html.find("</tr>", row) - row);
    EXPECT_THAT(cells, HasSubstr("<td>" + report::escape(metric.unit) + "</td>"));
    EXPECT_THAT(cells, HasSubstr(">" + report::escape(metric.definition) + "</td>"));
    EXPECT_THAT(cells, HasSubstr("class=num")) << metric.name;
  }
}

// Style and script are files of the tree; tools/cmake/embed.cmake puts them into the program.
TEST(Report, StyleAndScriptAreTheFilesOfTheTree) {
  const std::pair<const char*, std::string> kFiles[] = {{"page.css", report::page_style()},
                                                        {"page.js", report::page_script()},
                                                        {"tables.js", report::table_script()},
                                                        {"figure.css", report::figure_style()}};
  for (const auto& [name, embedded] : kFiles) {
    std::ifstream file(AR3D_SOURCE_DIR + std::string("/analysis/report/") + name);
    EXPECT_EQ(embedded, std::string(std::istreambuf_iterator<char>(file), {})) << name;
    EXPECT_FALSE(embedded.empty()) << name;
  }
}

TEST(Report, EscapesEveryStringOfTheFile) {
  const std::string html = report_of(hostile_results());
  EXPECT_EQ(occurrences(html, "<script"), 6u);
  EXPECT_EQ(occurrences(html, "</script"), 6u);
  EXPECT_THAT(html, Not(HasSubstr("<img")));
  EXPECT_THAT(html, Not(HasSubstr("\xff")));
  EXPECT_THAT(html, Not(HasSubstr("\x01")));
  EXPECT_THAT(html, HasSubstr("&lt;img src=x onerror=&#39;alert(2)&#39;&gt;&quot;&amp;"));
}

TEST(Report, EveryPlottedPointHasItsRowAndCommand) {
  const Results results = hostile_results();
  const std::string html = report_of(results);
  const auto data = nlohmann::json::parse(rows_json(html));
  std::size_t points = 0;
  for (std::size_t at = html.find(" data-r="); at != std::string::npos;
       at = html.find(" data-r=", at + 1)) {
    const std::size_t begin = html.find('=', at) + 1;
    const bool is_quoted = html[begin] == '\'';
    std::istringstream rows(html.substr(
        begin + is_quoted,
        html.find_first_of(is_quoted ? "'" : " >", begin + is_quoted) - begin - is_quoted));
    for (std::string row; rows >> row;) {
      ++points;
      ASSERT_TRUE(data["rows"].contains(row)) << row;
      const auto& fields = data["rows"][row];
      const auto& curve = data["curves"].at(fields[0].get<std::size_t>());
      EXPECT_EQ(curve[1].get<std::string>() + fields[1].dump() + " --seed " +
                    fields[3].get<std::string>() + curve[2].get<std::string>(),
                valid_utf8(draw_command(results.runs[std::stoul(row)])));
    }
  }
  // Side, volume and time: 26 graphs that were drawn and the crashed one; nine sizes in the heat
  // map, the closest graph in the head and in two tables.
  EXPECT_EQ(points, 3u * (9 * 3 - 1 + 1) + 9 + 3 + 1) << "and the finding about the crashed one";
  EXPECT_FALSE(data["rows"]["0"][4].is_number()) << "row 0 crashed";
}

TEST(Report, SettingsAreComparedAtEveryN) {
  Results results = good_results({"diamond"}, {"cubic"}, 9, 4);
  const std::size_t count_of_rows = results.runs.size();
  for (std::size_t i = 0; i < count_of_rows; ++i) {
    results.runs[i].options = "effort=0";
    results.runs.push_back(results.runs[i]);
    results.runs.back().options = "effort=1";
    results.runs.back().wall_s *= 3;
    results.runs.back().log2_volume -= 1;
  }
  const std::string html = report_of(results);
  EXPECT_EQ(occurrences(html, "<section id=trade>"), 1u);
  EXPECT_EQ(occurrences(html, "aria-label='Volume against drawing time, n = "), 9u);
  EXPECT_EQ(occurrences(html, "<polyline class='front'"), 9u);
  EXPECT_EQ(occurrences(html, "aria-label='Volume against n'"), 1u);
  EXPECT_EQ(occurrences(html, "class='crossing'"), 0u) << "one is below the other everywhere";
  EXPECT_EQ(
      occurrences(report_of(good_results({"diamond"}, {"cubic"}, 9, 4)), "<section id=trade>"), 0u)
      << "one setting has nothing to compare";
}

// Who drew other families is compared apart.
TEST(Report, SettingsWithoutACommonFamilyAreNotCompared) {
  Results results = good_results({"diamond", "grid", "compact"}, {"cubic", "prism"}, 9, 2);
  std::erase_if(results.runs, [](const ar3d::RunRecord& run) {
    return (run.algorithm == "grid" && run.family == "prism") ||
           (run.algorithm == "compact" && run.family == "cubic");
  });
  const std::string html = report_of(results);
  EXPECT_THAT(html, HasSubstr("<option value=0 selected>cubic, which 2 settings drew</option>"));
  EXPECT_THAT(html, HasSubstr("<option value=1>prism, which 2 settings drew</option>"));
  EXPECT_EQ(occurrences(html, "<figure data-fig='volume"), 2u);
  EXPECT_EQ(occurrences(html, " data-group=1 data-n="), 9u);
}

// A value in the order of the theorem's bound is a horizontal line.
TEST(Report, GrowthIsDividedByTheOrderOfTheBound) {
  Results results = good_results({"diamond"}, {"cubic"}, 9, 1);
  for (ar3d::RunRecord& run : results.runs) run.extents = {run.n, run.n, 5 * run.n};
  const auto figures = report_figures(analyse(view_of(results)));
  const auto side = std::find_if(figures.begin(), figures.end(), [](const Figure& figure) {
    return figure.name == "diamond-longest-side";
  });
  ASSERT_NE(side, figures.end());
  EXPECT_EQ(occurrences(side->csv, ",cubic,line,"), 9u);
  EXPECT_THAT(side->csv, HasSubstr(",cubic,line,16,5,5,5\r\n"));
  EXPECT_THAT(side->csv, HasSubstr(",cubic,line,4096,5,5,5\r\n"));
  EXPECT_THAT(side->csv, HasSubstr(",theorem's bound,dashed,4096,8,,\r\n"));
  EXPECT_THAT(side->csv, HasSubstr(",all families,band,4096,5,5,5\r\n"));
}

TEST(Report, VolumesLieInABandBetweenTheirBounds) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 2);
  const auto band_of = [&] {
    std::string csv;
    for (const Figure& figure : report_figures(analyse(view_of(results)))) {
      if (figure.name == "diamond-volume-band") csv = figure.csv;
    }
    return csv;
  };
  EXPECT_EQ(band_of(), "") << "rows of earlier programs have no bound from below";
  for (ar3d::RunRecord& run : results.runs) {
    const std::int64_t least = run.n * run.n * run.n;
    run_column("volume_at_least").load(reinterpret_cast<const char*>(&least), run);
    run.log2_volume = std::log2(8.0 * static_cast<double>(least));
  }
  EXPECT_THAT(band_of(),
              HasSubstr("band,64,8,1,2"));  // divided by n^3; the theorem's is 228 and more
}

TEST(Report, SetsWhatIsDrawnBesideWhatWasPromised) {
  Results results = good_results({"diamond"}, {"cubic"}, 9, 1);
  for (ar3d::RunRecord& run : results.runs) run.extents = {run.n, run.n, 5 * run.n};
  const std::string html = render_report(analyse(view_of(results)));
  EXPECT_THAT(html, HasSubstr("<td>z</td><td class=num>–</td><td class=num>8 n</td>"
                              "<td class=num>1.000 <small>[1.000, 1.000]</small></td><td>cubic"
                              "</td><td class=num>5</td><td>cubic</td>"));
}

TEST(Report, OfManyFamiliesTheExtremeOnesAreNamed) {
  std::vector<std::string> families;
  for (int i = 0; i < 30; ++i) families.push_back("family-" + std::to_string(i));
  Results results = good_results({"diamond"}, families, 5, 1);
  for (ar3d::RunRecord& run : results.runs) {
    const auto place = std::find(families.begin(), families.end(), run.family) - families.begin();
    run.extents = {run.n, run.n, run.n * (100 + place) / 40};
  }
  const std::string html = report_of(results);
  const std::size_t begin = html.find("<figure data-fig='diamond-longest-side'");
  const std::string figure = html.substr(begin, html.find("</figure>", begin) - begin);
  EXPECT_EQ(occurrences(figure, "<g class='family"), 30u);
  EXPECT_EQ(occurrences(figure, "<g class='family extreme'"), 4u);
  for (const char* name : {">family-29<", ">family-28<", ">family-1<", ">family-0<"}) {
    EXPECT_EQ(occurrences(figure.substr(figure.find("class='ends'")), name), 2u)
        << "name and title";
  }
  // The family closest to its bound stands first in the heat map.
  const std::string heat = html.substr(html.find("<table class='heat"));
  EXPECT_LT(heat.find(">family-29<"), heat.find(">family-28<"));
  EXPECT_LT(heat.find(">family-28<"), heat.find(">family-0<"));
}

TEST(Report, OfVeryManyFamiliesThePageShowsTheClosest) {
  std::vector<std::string> families;
  for (int i = 0; i < 400; ++i) families.push_back("family-" + std::to_string(i));
  Results results = good_results({"diamond"}, families, 2, 1);
  results.runs.back().extents[2] = 8 * results.runs.back().n;  // touches the bound
  results.runs[20].extents[2] = 1;                             // in a family far from its bound
  results.runs[20].violations = 1;
  const std::string html = report_of(results);
  EXPECT_THAT(html, HasSubstr("The 300 of 400 families that come closest to the bound"));
  const std::size_t front = html.find("<section id=closeness>");
  EXPECT_THAT(html.substr(front, html.find("</section>", front) - front),
              HasSubstr("<td class=num>400</td><td class=num>800</td><td class=num>32</td>"
                        "<td class=num><b class=violated>2</b></td>"))
      << "families, graphs and violations of all rows";
  EXPECT_THAT(html, HasSubstr(">family-399<"));
}

TEST(Report, BatchesAreShownAgainstTheIdeal) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 1);
  EXPECT_EQ(occurrences(report_of(results), "id=strong-weak"), 0u) << "there are no batches";
  const ar3d::RunRecord like = results.runs.back();
  for (const RunPhase phase : {RunPhase::strong, RunPhase::weak, RunPhase::weak_ranks}) {
    for (const std::int64_t threads : {1, 2, 4}) {
      ar3d::RunRecord run = like;
      run.phase = phase;
      run.scale = threads;
      run.ideal_batch_s = 0.012;
      run.efficiency = threads == 4 ? 0.75 : 1;
      run.batch_s = run.ideal_batch_s / run.efficiency;
      results.runs.push_back(run);
    }
  }
  const std::string html = report_of(results);
  EXPECT_EQ(occurrences(html, "<section id=strong-weak>"), 1u);
  EXPECT_EQ(occurrences(html, "strong scaling: drawings at a time against threads'"), 1u);
  EXPECT_EQ(occurrences(html, "weak scaling: drawings at a time against threads'"), 1u);
  EXPECT_EQ(occurrences(html, "weak scaling over ranks: drawings at a time against ranks'"), 1u);
  EXPECT_EQ(occurrences(html, "<td class=num>4 ranks</td>"), 1u);
  EXPECT_EQ(occurrences(html, "<title>ideal</title>"), 3u);
  EXPECT_EQ(occurrences(html,
                        "<td class=num>16 ms</td><td class=num>12 ms</td>"
                        "<td class=num>75.0 %</td>"),
            3u);
  EXPECT_EQ(report_figures(analyse(view_of(results))).size(), 4u + 3)
      << "three more than without batches";
}

TEST(Report, FiguresAreDocumentsOfTheirOwn) {
  const Results results = hostile_results();
  const std::vector<Figure> figures = report_figures(analyse(view_of(results)));
  ASSERT_EQ(figures.size(), 4u) << "side, volume, time and bends";
  std::set<std::string> names;
  for (const Figure& figure : figures) {
    EXPECT_TRUE(names.insert(figure.name).second);
    EXPECT_EQ(figure.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"),
              std::string::npos)
        << figure.name;
    EXPECT_THAT(figure.svg, StartsWith("<?xml version='1.0' encoding='UTF-8'?>\n<svg "));
    EXPECT_THAT(figure.svg, Not(HasSubstr("var(--")));
    boost::property_tree::ptree tree;
    std::istringstream in(figure.svg);
    EXPECT_NO_THROW(boost::property_tree::read_xml(in, tree)) << figure.name;
    EXPECT_THAT(figure.csv, StartsWith("id,series,kind,x,y,low,high\r\n0,"));
    EXPECT_THAT(figure.matplotlib, HasSubstr("open(here / \"" + figure.name + ".csv\""));
    EXPECT_THAT(figure.pgfplots, HasSubstr("{" + figure.name + ".csv}"));
  }
}

TEST(Report, OfNothingSaysSo) {
  const std::string html = report_of(Results{});
  EXPECT_THAT(html, HasSubstr(">INCOMPLETE<"));
  EXPECT_THAT(html, HasSubstr("Nothing was measured"));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(Report, SaysOfWhatKindTheHashOfTheSpecificationIs) {
  const Results results = good_results({"diamond"}, {"cubic"}, 3, 1);
  EXPECT_THAT(report_of(results), HasSubstr("XXH3-128 " + content_hash(results.spec)));
}

TEST(Report, NamesViolationsAndTheirCommand) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 2);
  results.runs[3].extents[2] = 999999;
  const std::string html = report_of(results);
  EXPECT_THAT(html, HasSubstr(">VIOLATED<"));
  EXPECT_THAT(html, HasSubstr("extent 999999 along z passes the theorem"));
  EXPECT_THAT(html, HasSubstr("<code>ar3d generate cubic -n 32 --seed 32001 | ar3d draw"));
}

TEST(Report, FindingsNameWhatDrewWhichGraphAndOpenIt) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 2);
  results.runs[3].options = "effort=2";
  results.runs[3].extents[2] = 999999;
  const StudyAnalysis analysis = analyse(view_of(results));
  EXPECT_EQ(rows_to_show(analysis, 5, 1000).front(), 3u);
  EXPECT_THAT(render_report(analysis),
              HasSubstr("<button type=button class=graph data-r=3>row 3, diamond (effort=2) on "
                        "cubic, n = 32, graph 1</button>: extent 999999 along z"));
}

TEST(Report, MissingNumbersAreNeverPrintedAsNumbers) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 2);
  for (auto& run : results.runs) {
    run.wall_s = run.log2_volume = kMissing;
    run.theorem_bound = {kMissing, kMissing, kMissing};
    run.instance_bound = {-1, -1, -1};
  }
  const std::string html = report_of(results);
  const std::string page = html.substr(0, html.find("<script"));
  EXPECT_FALSE(has_word(page, "nan"));
  EXPECT_FALSE(has_word(page, "inf"));
}

TEST(Export, CsvHasOneLineACellAndQuotes) {
  Results results = good_results({"diamond"}, {"a,\"b\"", "prism"}, 2, 2);
  results.runs[0].theorem_bound[0] = kMissing;
  const std::string csv = bounds_csv(analyse(view_of(results)));
  EXPECT_EQ(occurrences(csv, "\r\n"), 3u);
  EXPECT_THAT(csv, HasSubstr("diamond,,\"a,\"\"b\"\"\",,16,32,4,4,0,"));
  EXPECT_THAT(csv, Not(HasSubstr("nan")));
  std::string boxes;
  rows_csv(view_of(results), [&](std::string_view text) { boxes += text; });
  EXPECT_EQ(occurrences(boxes, "\r\n"), 1u + results.runs.size());
  for (const Metric& metric : metrics()) EXPECT_THAT(boxes, HasSubstr("," + metric.name + ","));
  EXPECT_THAT(boxes, HasSubstr("\r\n0,diamond,,\"a,\"\"b\"\"\",,16,32,16000,ok,"));
  EXPECT_THAT(boxes, Not(HasSubstr("nan")));
  const std::string growth = scaling_csv(analyse(view_of(results)));
  EXPECT_EQ(occurrences(growth, "\r\n"), 1u + 2 * 6);
  EXPECT_THAT(growth, HasSubstr("undecided"));
}

TEST(Export, JsonHoldsVerdictBoundsAndGrowth) {
  const Results results = good_results({"diamond"}, {"cubic"}, 9, 4);
  const auto json = nlohmann::json::parse(analysis_json(analyse(view_of(results))));
  EXPECT_EQ(json["verdict"]["exit_code"], 0);
  EXPECT_EQ(json["bounds"].size(), 1u);
  EXPECT_EQ(json["bounds"][0]["axes"].size(), 3u);
  EXPECT_EQ(json["scaling"].size(), 6u);
  EXPECT_NEAR(json["scaling"][0]["exponent"].get<double>(), 1, 0.05);
  const Results hostile = hostile_results(), nothing;
  EXPECT_NO_THROW(nlohmann::json::parse(analysis_json(analyse(view_of(hostile)))));
  EXPECT_EQ(nlohmann::json::parse(analysis_json(analyse(view_of(nothing))))["verdict"]["exit_code"],
            5);
}

}  // namespace
}  // namespace ar3d::testing
