// The tables of a report, and the page that holds them.
#include "ar3d/analysis/report/report.h"

#include <cmath>
#include <set>

#include "analysis/synthetic.h"
#include "ar3d/analysis/tally.h"
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

TEST(Report, IsOnePageThatNeedsNothingFromOutside) {
  const std::string html = report_of(good_results({"diamond", "grid"}, {"cubic"}, 9, 4));
  EXPECT_EQ(occurrences(html, "<script>"), 2u) << "ours, and Plot's";
  EXPECT_EQ(occurrences(html, "<style>"), 1u);
  for (const char* outside : {"src=http", "src='http", "src=\"http", "src=//", "href=http",
                              "href='http", "href=\"http", "href=//", "@import"}) {
    EXPECT_EQ(occurrences(html, outside), 0u) << outside;
  }
  const std::string policy = html.substr(html.find("default-src 'none'"), 300);
  EXPECT_EQ(occurrences(policy, "'sha256-"), 2u);
  EXPECT_EQ(occurrences(policy, "unsafe-inline"), 1u) << "styles only";
  EXPECT_LT(html.size(), 1'000'000u);
}

// What a results file says is data of the page, never markup.
TEST(Report, HostileStringsStayData) {
  const std::string html = report_of(hostile_results());
  const std::string plain = report_of(good_results({"diamond"}, {"cubic"}, 9, 3));
  EXPECT_EQ(occurrences(html, "<script"), occurrences(plain, "<script"));
  EXPECT_EQ(occurrences(html, "</script"), occurrences(plain, "<script"));
  for (const char* raw : {"<img", "alert(1)<", "\xff", "\x01"}) {
    EXPECT_EQ(occurrences(html.substr(0, html.find("<script>")), raw), 0u) << raw;
  }
  EXPECT_EQ(occurrences(html, "<title>ar3d report: &lt;/script&gt;"), 1u);
  EXPECT_THAT(tables_of(hostile_results())["study"][0]["study"].get<std::string>(),
              StartsWith("</script><script>alert(1)"));
}

TEST(Report, EveryTableSaysWhatItsColumnsAre) {
  const Results results = good_results({"diamond", "grid"}, {"cubic"}, 9, 2);
  std::set<std::string> names;
  for (const Table& table : report_tables(analyse(Rows(results)), {}, {}, true)) {
    EXPECT_TRUE(names.insert(table.name).second) << table.name;
    EXPECT_EQ(table.cells.size() % table.columns.size(), 0u);
    EXPECT_NE(table.row_is, "");
    std::set<std::string> columns;
    for (const TableColumn& column : table.columns) {
      EXPECT_TRUE(columns.insert(column.name).second) << table.name << ' ' << column.name;
      EXPECT_NE(column.meaning, "") << table.name << ' ' << column.name;
    }
  }
  for (const char* name : {"verdict", "findings", "settings", "promises", "bounds", "growth",
                           "curves", "trade", "crossings", "profile", "pairs", "bins", "scaling",
                           "precision", "real_drawings", "since"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(Report, HoldsEveryMetricWithUnitAndDefinition) {
  const auto tables = tables_of(good_results({"diamond"}, {"cubic"}, 9, 4));
  ASSERT_EQ(tables["metrics"].size(), metrics().size());
  for (std::size_t i = 0; i < metrics().size(); ++i) {
    EXPECT_EQ(tables["metrics"][i]["metric"], metrics()[i].name);
    EXPECT_EQ(tables["metrics"][i]["unit"], metrics()[i].unit);
    EXPECT_EQ(tables["metrics"][i]["definition"], metrics()[i].definition);
  }
  const auto sides = rows_with(tables["metric_values"], "metric", 0);
  ASSERT_EQ(sides.size(), 1u);
  EXPECT_EQ(sides[0]["n"], 16 << 8);
}

TEST(Report, EveryPointHasItsRowAndCommand) {
  const Results results = hostile_results();
  const auto tables = tables_of(results);
  std::size_t points = 0;
  for (const auto& graph : tables["graphs"]) {
    const auto& curve = tables["bounds"][graph["curve"].get<std::size_t>()];
    points += graph["is_point"].get<bool>();
    EXPECT_EQ(curve["command"].get<std::string>() + graph["n"].dump() + " --seed " +
                  graph["seed"].get<std::string>() + curve["command_end"].get<std::string>(),
              valid_utf8(draw_command(results.runs[graph["row"].get<std::size_t>()])));
  }
  EXPECT_EQ(points, 9u * 3);
  EXPECT_EQ(tables["graphs"][0]["status"], "crashed");
  EXPECT_EQ(tables["graphs"][1]["status"], nullptr);
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
  const auto tables = tables_of(timed(results));
  EXPECT_EQ(tables["groups"].size(), 1u);
  EXPECT_EQ(tables["trade"].size(), 2u * 9);
  EXPECT_EQ(rows_with(tables["trade"], "front", true).size(), 2u * 9)
      << "one is smaller, one faster";
  EXPECT_EQ(tables["crossings"].size(), 0u) << "one is below the other everywhere";
  EXPECT_EQ(tables_of(good_results({"diamond"}, {"cubic"}, 9, 4))["trade"].size(), 0u)
      << "one setting has nothing to compare";
}

// Times of rows that ran beside others are neither ranked nor drawn.
TEST(Report, TimesAreThoseOfTheTimingPhase) {
  const Results results = good_results({"diamond", "grid"}, {"cubic"}, 9, 2);
  const auto untimed = tables_of(results), with_times = tables_of(timed(results));
  EXPECT_EQ(rows_with(untimed["trade"], "time", nullptr).size(), 18u);
  EXPECT_EQ(rows_with(untimed["trade"], "front", true).size(), 0u);
  EXPECT_EQ(rows_with(untimed["curves"], "quantity", "drawing time").size(), 0u);
  EXPECT_EQ(rows_with(untimed["graphs"], "seconds", nullptr).size(), untimed["graphs"].size());
  EXPECT_EQ(rows_with(untimed["exponents"], "untimed", true).size(), 2u);
  EXPECT_EQ(rows_with(with_times["trade"], "time", nullptr).size(), 0u);
  EXPECT_GE(rows_with(with_times["trade"], "front", true).size(), 9u);
  EXPECT_EQ(rows_with(with_times["curves"], "quantity", "drawing time").size(), 18u);
  EXPECT_EQ(rows_with(with_times["exponents"], "untimed", true).size(), 0u);
  // A family that is not timed does not hide the exponent of one that is.
  Results some = timed(good_results({"diamond"}, {"cubic", "prism"}, 9, 2));
  std::erase_if(some.runs, [](const auto& run) {
    return run.family == "prism" && run.phase == ar3d::RunPhase::timing;
  });
  const auto front = rows_with(tables_of(some)["exponents"], "quantity", "drawing time").at(0);
  EXPECT_FALSE(front["untimed"]);
  int families = 0;
  for (const char* label : {"power", "logarithm", "apparent", "undecided"}) {
    families += front[label].get<int>();
  }
  EXPECT_EQ(families, 1);
}

// Who drew other families is compared apart.
TEST(Report, SettingsWithoutACommonFamilyAreNotCompared) {
  Results results = good_results({"diamond", "grid", "compact"}, {"cubic", "prism"}, 9, 2);
  std::erase_if(results.runs, [](const ar3d::RunRecord& run) {
    return (run.algorithm == "grid" && run.family == "prism") ||
           (run.algorithm == "compact" && run.family == "cubic");
  });
  const auto tables = tables_of(results);
  ASSERT_EQ(tables["groups"].size(), 2u);
  EXPECT_EQ(tables["groups"][0]["family"], "cubic");
  EXPECT_EQ(tables["groups"][1]["family"], "prism");
  EXPECT_EQ(rows_with(tables["trade"], "group", 1).size(), 2u * 9);
}

// A value in the order of the theorem's bound is a horizontal line.
TEST(Report, GrowthIsDividedByTheOrderOfTheBound) {
  Results results = good_results({"diamond"}, {"cubic"}, 9, 1);
  for (ar3d::RunRecord& run : results.runs) run.extents = {run.n, run.n, 5 * run.n};
  const auto tables = tables_of(results);
  const auto sides = rows_with(tables["curves"], "quantity", "z extent");
  ASSERT_EQ(sides.size(), 9u);
  for (const auto& side : sides) {
    for (const char* value : {"least", "median", "largest"}) EXPECT_NEAR(side[value], 5, 1e-4);
    EXPECT_EQ(side["divisor"], side["n"]);
    EXPECT_NEAR(side["bound"], 8, 1e-4);
  }
  EXPECT_NEAR(rows_with(tables["bands"], "quantity", "z extent").back()["median"], 5, 1e-4);
  EXPECT_NEAR(rows_with(tables["bound_lines"], "quantity", "z extent").back()["bound"], 8, 1e-4);
}

TEST(Report, VolumesLieInABandBetweenTheirBounds) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 2);
  EXPECT_EQ(tables_of(results)["volume_bands"].size(), 0u)
      << "rows of earlier programs have no bound from below";
  for (ar3d::RunRecord& run : results.runs) {
    const std::int64_t least = run.n * run.n * run.n;
    set_metric("volume_at_least", least, run);
    run.log2_volume = std::log2(8.0 * static_cast<double>(least));
  }
  const auto bands = tables_of(results)["volume_bands"];
  ASSERT_EQ(bands.size(), 3u);
  EXPECT_NEAR(bands[2]["least"], 1, 1e-4);  // divided by n^3; the theorem's is 228 and more
  EXPECT_NEAR(bands[2]["drawn"], 8, 1e-3);
  EXPECT_GT(bands[2]["most"], 228);
}

// Every exponent has its label; the interval of a power law is the one for larger n, too.
TEST(Report, ExponentsHaveLabelsAndTheirIntervals) {
  Results results = good_results({"diamond"}, {"cubic", "prism"}, 9, 1);
  for (ar3d::RunRecord& run : results.runs) {
    run.extents = {run.n, run.n, 5 * run.n};
    if (run.family == "prism") run.extents[2] += run.n % 7 == 2 ? run.n : 0;  // no line
  }
  const auto tables = tables_of(results);
  const auto front = rows_with(tables["exponents"], "quantity", "longest side").at(0);
  EXPECT_EQ(front["power"], 1);
  EXPECT_EQ(front["apparent"], 1);
  double low = 9, high = -9;
  for (const auto& row : rows_with(tables["growth"], "quantity", "longest side")) {
    const bool is_law = row["growth"] == "power law";
    EXPECT_NEAR(row["low"], row[is_law ? "law_low" : "exponent_low"], 1e-5);
    EXPECT_NEAR(row["high"], row[is_law ? "law_high" : "exponent_high"], 1e-5);
    low = std::min<double>(low, row["low"]), high = std::max<double>(high, row["high"]);
  }
  EXPECT_NEAR(front["low"], low, 1e-5);
  EXPECT_NEAR(front["high"], high, 1e-5);
  const auto promise = rows_with(tables["promises"], "axis", "x").at(0);
  EXPECT_EQ(promise["growth"], "power law");
  EXPECT_NEAR(promise["exponent"], 1, 1e-6);
  EXPECT_LE(promise["low"], 1);
}

TEST(Report, SetsWhatIsDrawnBesideWhatWasPromised) {
  Results results = good_results({"diamond"}, {"cubic"}, 9, 1);
  for (ar3d::RunRecord& run : results.runs) run.extents = {run.n, run.n, 5 * run.n};
  const auto promise = rows_with(tables_of(results)["promises"], "axis", "z").at(0);
  EXPECT_EQ(promise["paper"], nullptr);
  EXPECT_EQ(promise["proved"], "8 n");
  EXPECT_NEAR(promise["exponent"], 1, 1e-6);
  EXPECT_EQ(promise["family"], "cubic");
  EXPECT_NEAR(promise["constant"], 5, 1e-4);
  EXPECT_NEAR(promise["share"], 5.0 / 8, 1e-6);
}

TEST(Report, OfManyFamiliesTheExtremeOnesAreNamed) {
  std::vector<std::string> families;
  for (int i = 0; i < 30; ++i) families.push_back("family-" + std::to_string(i));
  Results results = good_results({"diamond"}, families, 5, 1);
  for (ar3d::RunRecord& run : results.runs) {
    const auto family = std::find(families.begin(), families.end(), run.family) - families.begin();
    run.extents = {run.n, run.n, run.n * (100 + family) / 40};
  }
  std::set<std::string> named;
  for (const auto& row : rows_with(tables_of(results)["growth"], "quantity", "z extent")) {
    if (!row["named"].is_null()) named.insert(row["family"]);
  }
  EXPECT_EQ(named, (std::set<std::string>{"family-29", "family-28", "family-1", "family-0"}));
}

TEST(Report, OfVeryManyFamiliesThePageShowsTheClosest) {
  std::vector<std::string> families;
  for (int i = 0; i < 400; ++i) families.push_back("family-" + std::to_string(i));
  Results results = good_results({"diamond"}, families, 2, 1);
  results.runs.back().extents[2] = 8 * results.runs.back().n;  // touches the bound
  results.runs[20].extents[2] = 1;                             // in a family far from its bound
  results.runs[20].violations = 1;
  const auto tables = tables_of(results);
  const auto setting = tables["settings"][0];
  EXPECT_EQ(setting["shown"], 300);
  EXPECT_EQ(setting["curves"], 400);
  EXPECT_EQ(setting["graphs"], 800) << "of all rows";
  EXPECT_EQ(setting["violations"], 2) << "of all rows";
  EXPECT_EQ(tables["bounds"][399]["is_shown"], true);
  EXPECT_EQ(rows_with(tables["bounds"], "is_shown", true).size(), 300u);
}

TEST(Report, BatchesAreShownAgainstTheIdeal) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 1);
  EXPECT_EQ(tables_of(results)["scaling"].size(), 0u) << "there are no batches";
  const ar3d::RunRecord like = results.runs.back();
  for (const RunPhase phase : {RunPhase::strong, RunPhase::weak, RunPhase::weak_ranks}) {
    for (const std::int64_t threads : {1, 2, 4}) {
      ar3d::RunRecord run = like;
      run.phase = phase;
      run.workers = threads;
      run.ideal_batch_s = 0.012;
      run.efficiency = threads == 4 ? 0.75 : 1;
      run.batch_s = run.ideal_batch_s / run.efficiency;
      results.runs.push_back(run);
    }
  }
  const auto scaling = tables_of(results)["scaling"];
  EXPECT_EQ(scaling.size(), 9u);
  EXPECT_EQ(rows_with(scaling, "kind", "strong").size(), 3u);
  EXPECT_EQ(rows_with(scaling, "shared_by", "ranks").size(), 3u);
  for (const auto& row : rows_with(scaling, "sharers", 4)) {
    EXPECT_NEAR(row["batch"], 0.016, 1e-9);
    EXPECT_NEAR(row["ideal"], 0.012, 1e-9);
    EXPECT_NEAR(row["at_a_time"], 3, 1e-9);
    EXPECT_EQ(row["crowded"], false) << "the number of cores is unknown";
  }
  const auto serial = rows_with(rows_with(scaling, "kind", "strong"), "sharers", 4).at(0);
  EXPECT_NEAR(serial["serial"], 1.0 / 9, 1e-5) << "1/9 alone and 8/9 shared by 4 take a third";
  EXPECT_EQ(rows_with(scaling, "serial", nullptr).size(), 7u);
  results.environment = {{"affinity", "0,1,2", 0}, {"cpu_quota", "1.50 cores", 0}};
  for (const auto& row : tables_of(results)["scaling"]) {
    EXPECT_EQ(row["crowded"], row["sharers"] == 4 && row["shared_by"] == "threads");
  }
}

TEST(Report, NamesTheHashOfTheSpecification) {
  const Results results = good_results({"diamond"}, {"cubic"}, 3, 1);
  EXPECT_EQ(tables_of(results)["study"][0]["spec_hash"], content_hash(results.spec));
}

TEST(Report, FindingsNameWhatDrewWhichGraphAndOpenIt) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 2);
  results.runs[3].options = "effort=2";
  results.runs[3].extents[2] = 999999;
  EXPECT_EQ(rows_to_show(analyse(Rows(results)), 5, 1000).front(), 3u);
  const auto tables = tables_of(results);
  EXPECT_EQ(tables["verdict"][0]["word"], "VIOLATED");
  const auto finding = tables["findings"][0];
  EXPECT_EQ(finding["row"], 3);
  EXPECT_EQ(finding["subject"], "diamond (effort=2) on cubic, n = 32, graph 1");
  EXPECT_THAT(finding["message"].get<std::string>(),
              HasSubstr("extent 999999 along z passes the theorem"));
  EXPECT_THAT(finding["command"].get<std::string>(),
              StartsWith("ar3d generate cubic -n 32 --seed 32001 | ar3d draw"));
  EXPECT_EQ(rows_with(tables["graphs"], "row", 3).size(), 1u);
}

TEST(Report, MissingNumbersAreNull) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 2);
  for (auto& run : results.runs) {
    run.wall_s = run.log2_volume = kMissing;
    run.theorem_bound = {kMissing, kMissing, kMissing};
    run.instance_bound = {-1, -1, -1};
  }
  const auto tables = tables_of(results);  // JSON has no NaN
  EXPECT_EQ(tables["settings"][0]["share"], nullptr);
  EXPECT_EQ(tables["bounds"][0]["log2_volume"], nullptr);
}

TEST(Export, CsvHasOneLineACellAndQuotes) {
  Results results = good_results({"diamond"}, {"a,\"b\"", "prism"}, 2, 2);
  results.runs[0].theorem_bound[0] = kMissing;
  const std::string csv = bounds_csv(analyse(Rows(results)));
  EXPECT_EQ(occurrences(csv, "\r\n"), 3u);
  EXPECT_THAT(csv, HasSubstr("diamond,,\"a,\"\"b\"\"\",,16,32,4,4,0,"));
  EXPECT_THAT(csv, Not(HasSubstr("nan")));
  std::string boxes;
  rows_csv(Rows(results), [&](std::string_view text) { boxes += text; });
  EXPECT_EQ(occurrences(boxes, "\r\n"), 1u + results.runs.size());
  for (const Metric& metric : metrics()) EXPECT_THAT(boxes, HasSubstr("," + metric.name + ","));
  EXPECT_THAT(boxes,
              ContainsRegex("\r\n0,[0-9a-f]*,diamond,,\"a,\"\"b\"\"\",,,,[0-9]*,16,32,16000,ok,"));
  EXPECT_THAT(boxes, Not(HasSubstr("nan")));
  for (const std::string formula : {"=1+1", "+1+1", "-1+1", "@SUM(A1)", "\tx"}) {
    Results hostile = good_results({"diamond"}, {formula}, 2, 2);
    EXPECT_THAT(bounds_csv(analyse(Rows(hostile))), HasSubstr(",\"'" + formula + "\","));
  }
  const std::string growth = scaling_csv(analyse(Rows(results)));
  EXPECT_EQ(occurrences(growth, "\r\n"), 1u + 2 * 6);
  EXPECT_THAT(growth, HasSubstr("undecided"));
}

TEST(Export, JsonHoldsAllTablesWithAllDigits) {
  const Results results = good_results({"diamond"}, {"cubic"}, 9, 4);
  const Rows of_results(results);
  const StudyAnalysis analysis = analyse(of_results);
  const auto json = nlohmann::json::parse(analysis_json(analysis));
  EXPECT_EQ(json["format"], "ar3d tables 1");
  const auto tables = rows_by_table(report_tables(analysis, {}, {}, true));
  EXPECT_EQ(tables["bounds"].size(), 1u);
  EXPECT_EQ(tables["growth"].size(), 6u);
  EXPECT_EQ(tables["growth"][0]["exponent"].get<double>(), analysis.scaling[0].power.exponent);
  EXPECT_EQ(rows_with(tables["curves"], "quantity", "z extent").size(), 9u) << "the page has three";
  const Results hostile = hostile_results(), nothing;
  EXPECT_NO_THROW(nlohmann::json::parse(analysis_json(analyse(Rows(hostile)))));
  EXPECT_NO_THROW(nlohmann::json::parse(analysis_json(analyse(Rows(nothing)))));
}

}  // namespace
}  // namespace ar3d::testing
