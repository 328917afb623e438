#include "ar3d/analysis/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/property_tree/xml_parser.hpp>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "analysis/synthetic.h"
#include "ar3d/analysis/export.h"
#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/report/axis.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/page_files.h"
#include "ar3d/analysis/text.h"

namespace ar3d {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
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
  Results results = testing::good_results({"diamond"}, {"cubic" + attack}, 9, 3);
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
  const std::string html =
      testing::report_of(testing::good_results({"diamond", "grid"}, {"cubic"}, 9, 4));
  EXPECT_EQ(count(html, "<script"), 2u) << "the data and one script, each once";
  EXPECT_EQ(count(html, "<style"), 1u);
  for (const char* outside : {"src=http", "src='http", "src=\"http", "src=//", "href=http",
                              "href='http", "href=\"http", "href=//", "@import", "url("}) {
    EXPECT_EQ(count(html, outside), 0u) << outside;
  }
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  EXPECT_THAT(html, HasSubstr(">PASS<"));
  EXPECT_EQ(count(html, "<svg class='plot'"), 2u * (3 + 3 + 2))
      << "three overviews, and by family three, those that have a fit with residuals";
  EXPECT_EQ(count(html, "<svg class='plot bars'"), 2u);
  EXPECT_EQ(count(html, "id=effort"), 0u) << "one setting has nothing to compare";
  EXPECT_LT(html.size(), 2'000'000u);
}

TEST(Report, ShowsEveryMetricOfTheTableWithUnitAndDefinition) {
  const std::string html = testing::report_of(testing::good_results({"diamond"}, {"cubic"}, 9, 4));
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

// Style and script are files of the tree; cmake/embed.cmake puts them into the program.
TEST(Report, StyleAndScriptAreTheFilesOfTheTree) {
  const std::pair<const char*, std::string> kFiles[] = {{"page.css", report::page_style()},
                                                        {"page.js", report::page_script()},
                                                        {"figure.css", report::figure_style()}};
  for (const auto& [name, embedded] : kFiles) {
    std::ifstream file(AR3D_SOURCE_DIR + std::string("/analysis/report/") + name);
    EXPECT_EQ(embedded, std::string(std::istreambuf_iterator<char>(file), {})) << name;
    EXPECT_FALSE(embedded.empty()) << name;
  }
}

TEST(Report, EscapesEveryStringOfTheFile) {
  const std::string html = testing::report_of(hostile_results());
  EXPECT_EQ(count(html, "<script"), 2u);
  EXPECT_EQ(count(html, "</script"), 2u);
  EXPECT_THAT(html, Not(HasSubstr("<img")));
  EXPECT_THAT(html, Not(HasSubstr("\xff")));
  EXPECT_THAT(html, Not(HasSubstr("\x01")));
  EXPECT_THAT(html, HasSubstr("&lt;img src=x onerror=&#39;alert(2)&#39;&gt;&quot;&amp;"));
}

TEST(Report, EveryPlottedPointHasItsRowAndCommand) {
  const Results results = hostile_results();
  const std::string html = testing::report_of(results);
  const auto data = nlohmann::json::parse(rows_json(html));
  const std::string mark = "data-r='";
  std::size_t points = 0;
  for (std::size_t at = html.find(mark); at != std::string::npos; at = html.find(mark, at)) {
    at += mark.size();
    std::istringstream rows(html.substr(at, html.find('\'', at) - at));
    for (std::string row; rows >> row;) {
      ++points;
      ASSERT_TRUE(data["rows"].contains(row)) << row;
      const auto& fields = data["rows"][row];
      const auto& cell = data["cells"].at(fields[0].get<std::size_t>());
      EXPECT_EQ(cell[1].get<std::string>() + fields[1].dump() + " --seed " +
                    fields[3].get<std::string>() + cell[2].get<std::string>(),
                valid_utf8(draw_command(results.runs[std::stoul(row)])));
    }
  }
  // Side, volume and time: 26 graphs that were drawn and the crashed one; side and volume: 9
  // residuals.
  EXPECT_EQ(points, 3u * (9 * 3 - 1 + 1) + 2u * 9);
  EXPECT_FALSE(data["rows"]["0"][4].is_number()) << "row 0 crashed";
}

TEST(Report, ResidualsAndEffortsAreShownWhereThereAreSome) {
  Results results = testing::good_results({"diamond"}, {"cubic"}, 9, 4);
  const std::size_t count_of_rows = results.runs.size();
  for (std::size_t i = 0; i < count_of_rows; ++i) {
    results.runs[i].options = "effort=0";
    results.runs.push_back(results.runs[i]);
    results.runs.back().options = "effort=1";
    results.runs.back().wall_s *= 3;
  }
  const std::string html = testing::report_of(results);
  EXPECT_EQ(count(html, "aria-label='residuals of the"), 2u * 2);
  EXPECT_EQ(count(html, "<section id=effort>"), 1u);
  EXPECT_EQ(count(html, "aria-label='volume against drawing time of diamond by setting'"), 1u);
}

TEST(Report, BatchesAreShownAgainstTheIdeal) {
  Results results = testing::good_results({"diamond"}, {"cubic"}, 3, 1);
  EXPECT_EQ(count(testing::report_of(results), "id=strong-weak"), 0u) << "there are no batches";
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
  const std::string html = testing::report_of(results);
  EXPECT_EQ(count(html, "<section id=strong-weak>"), 1u);
  EXPECT_EQ(count(html, "strong scaling: drawings at a time against threads'"), 1u);
  EXPECT_EQ(count(html, "weak scaling: drawings at a time against threads'"), 1u);
  EXPECT_EQ(count(html, "weak scaling over ranks: drawings at a time against ranks'"), 1u);
  EXPECT_EQ(count(html, "<td class=num>4 ranks</td>"), 1u);
  EXPECT_EQ(count(html, "<title>ideal</title>"), 3u);
  EXPECT_EQ(count(html,
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
    EXPECT_THAT(figure.svg, ::testing::StartsWith("<?xml version='1.0' encoding='UTF-8'?>\n<svg "));
    EXPECT_THAT(figure.svg, Not(HasSubstr("var(--")));
    boost::property_tree::ptree tree;
    std::istringstream in(figure.svg);
    EXPECT_NO_THROW(boost::property_tree::read_xml(in, tree)) << figure.name;
  }
}

TEST(Report, OfNothingSaysSo) {
  const std::string html = testing::report_of(Results{});
  EXPECT_THAT(html, HasSubstr(">INCOMPLETE<"));
  EXPECT_THAT(html, HasSubstr("Nothing was measured"));
  EXPECT_THAT(html, Not(HasSubstr("nan")));
}

TEST(Report, SaysOfWhatKindTheHashOfTheSpecificationIs) {
  const Results results = testing::good_results({"diamond"}, {"cubic"}, 3, 1);
  EXPECT_THAT(testing::report_of(results), HasSubstr("XXH3-128 " + content_hash(results.spec)));
}

TEST(Report, NamesViolationsAndTheirCommand) {
  Results results = testing::good_results({"diamond"}, {"cubic"}, 3, 2);
  results.runs[3].extents[2] = 999999;
  const std::string html = testing::report_of(results);
  EXPECT_THAT(html, HasSubstr(">VIOLATED<"));
  EXPECT_THAT(html, HasSubstr("extent 999999 along z passes the theorem"));
  EXPECT_THAT(html, HasSubstr("<code>ar3d generate cubic -n 32 --seed 32001 | ar3d draw"));
}

TEST(Report, MissingNumbersAreNeverPrintedAsNumbers) {
  Results results = testing::good_results({"diamond"}, {"cubic"}, 3, 2);
  for (auto& run : results.runs) {
    run.wall_s = run.log2_volume = kMissing;
    run.theorem_bound = {kMissing, kMissing, kMissing};
    run.instance_bound = {-1, -1, -1};
  }
  const std::string html = testing::report_of(results);
  const std::string page = html.substr(0, html.find("<script"));
  EXPECT_FALSE(has_word(page, "nan"));
  EXPECT_FALSE(has_word(page, "inf"));
}

TEST(Axis, TicksAreDecadesOrOneTwoFive) {
  const auto labels = [](const report::LogAxis& axis, report::TickStyle style) {
    std::vector<std::string> labels;
    for (const report::Tick& tick : axis.ticks(style, 6)) {
      if (!tick.label.empty()) labels.push_back(tick.label);
    }
    return labels;
  };
  EXPECT_THAT(labels({1, 5, 0, 100}, report::TickStyle::count),
              ::testing::ElementsAre("10", "100", "1k", "10k", "100k"));
  EXPECT_THAT(labels({2, 3, 0, 100}, report::TickStyle::count),
              ::testing::ElementsAre("100", "200", "500", "1k"));
  EXPECT_THAT(labels({-6, -2, 0, 100}, report::TickStyle::seconds),
              ::testing::ElementsAre("1 µs", "10 µs", "100 µs", "1 ms", "10 ms"));
  EXPECT_THAT(labels({0, 20, 0, 100}, report::TickStyle::power),
              ::testing::ElementsAre("1", "10⁴", "10⁸", "10¹²", "10¹⁶", "10²⁰"));
  EXPECT_THAT(labels({10.3, 10.5, 0, 100}, report::TickStyle::power),
              ::testing::ElementsAre("2·10¹⁰", "2.5·10¹⁰", "3·10¹⁰"));
  EXPECT_THAT(labels({2.05, 2.2, 0, 100}, report::TickStyle::count),
              ::testing::ElementsAre("120", "130", "140", "150", "160"));
  EXPECT_THAT(labels({0, 0.3, 0, 100}, report::TickStyle::count),
              ::testing::ElementsAre("1", "1.5", "2"));
}

TEST(Html, Numbers) {
  EXPECT_EQ(report::grouped(1234567), "1,234,567");
  EXPECT_EQ(report::grouped(-123), "-123");
  EXPECT_EQ(report::grouped(-1234), "-1,234");
  EXPECT_EQ(report::duration(0.00123), "1.23 ms");
  EXPECT_EQ(report::duration(kMissing), "–");
  EXPECT_EQ(report::percent(0.5), "50.0 %");
}

TEST(Export, CsvHasOneLineACellAndQuotes) {
  Results results = testing::good_results({"diamond"}, {"a,\"b\"", "prism"}, 2, 2);
  results.runs[0].theorem_bound[0] = kMissing;
  const std::string csv = bounds_csv(analyse(view_of(results)));
  EXPECT_EQ(count(csv, "\r\n"), 3u);
  EXPECT_THAT(csv, HasSubstr("diamond,,\"a,\"\"b\"\"\",,16,32,4,4,0,"));
  EXPECT_THAT(csv, Not(HasSubstr("nan")));
  std::string boxes;
  rows_csv(view_of(results), [&](std::string_view text) { boxes += text; });
  EXPECT_EQ(count(boxes, "\r\n"), 1u + results.runs.size());
  for (const Metric& metric : metrics()) EXPECT_THAT(boxes, HasSubstr("," + metric.name + ","));
  EXPECT_THAT(boxes, HasSubstr("\r\n0,diamond,,\"a,\"\"b\"\"\",,16,32,16000,ok,"));
  EXPECT_THAT(boxes, Not(HasSubstr("nan")));
  const std::string growth = scaling_csv(analyse(view_of(results)));
  EXPECT_EQ(count(growth, "\r\n"), 1u + 2 * 6);
  EXPECT_THAT(growth, HasSubstr("undecided"));
}

TEST(Export, JsonHoldsVerdictBoundsAndGrowth) {
  const Results results = testing::good_results({"diamond"}, {"cubic"}, 9, 4);
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
}  // namespace ar3d
