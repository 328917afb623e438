// What a report shows beside its study: changes since a reference, and drawings.
#include <set>

#include "analysis/synthetic.h"
#include "ar3d/analysis/report/report.h"

namespace ar3d::testing {
namespace {

/// The tables of `now`, compared with `base`.
nlohmann::json tables_since(const Results& base, const Results& now) {
  return tables_of(now, {"0.1.0-base.h5", "long ago", compare(base, now), ""});
}

TEST(ReportParts, SaysWhatChangedSinceTheReference) {
  const Results base = good_results({"diamond"}, {"cubic", "prism"}, 9, 4);
  const auto alike = tables_since(base, base);
  EXPECT_EQ(alike["since"][0]["file"], "0.1.0-base.h5");
  EXPECT_EQ(alike["since"][0]["word"], "PASS");
  EXPECT_EQ(alike["since"][0]["is_copy"], true);
  EXPECT_EQ(alike["since_cells"].size(), 0u);

  Results now = base;
  for (RunRecord& run : now.runs) {
    run.wall_s *= 1.001;
    if (run.family == "prism" && run.n == 64) run.extents[1] *= 2;
    if (run.family == "prism" && run.n == 64) run.log2_volume += 1;
  }
  const auto worse = tables_since(base, now);
  EXPECT_EQ(worse["since"][0]["word"], "REGRESSED");
  ASSERT_EQ(worse["since_cells"].size(), 1u);
  EXPECT_EQ(worse["since_cells"][0]["setting"], "diamond");
  EXPECT_EQ(worse["since_cells"][0]["family"], "prism");
  EXPECT_EQ(worse["since_cells"][0]["n"], 64);
  EXPECT_NEAR(worse["since_cells"][0]["volume"], 2, 0.01);

  now.environment.push_back({"flags", "-O0", 0});
  const auto unlike = tables_since(base, now);
  EXPECT_EQ(unlike["since"][0]["time_judged"], false);
  const auto flags = rows_with(unlike["since_environment"], "name", "flags").at(0);
  EXPECT_EQ(flags["base"], "absent");
  EXPECT_EQ(flags["now"], "-O0");
  EXPECT_EQ(flags["differs"], true);

  now.environment = {{"load_before", "9.00", 0}};
  Results busy = base;
  busy.environment = now.environment;
  const auto load =
      rows_with(tables_since(busy, now)["since_environment"], "name", "load of other work").at(0);
  EXPECT_EQ(load["differs"], false);
  EXPECT_EQ(load["now"], "9.00");
  EXPECT_THAT(summary(compare(busy, now), {}), HasSubstr("BUSY MACHINE: times are shown, but"));

  EXPECT_EQ(tables_of(base)["since"][0]["why_none"], "No reference was given.");
}

TEST(ReportParts, StoresTheGraphsThatComeClosestFirst) {
  const Results results = good_results({"diamond", "grid"}, {"cubic", "prism"}, 5, 2);
  const Rows of_results(results);
  const StudyAnalysis analysis = analyse(of_results);
  const std::vector<std::size_t> rows = rows_to_show(analysis, 7, 128);
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_EQ(std::set<std::size_t>(rows.begin(), rows.end()).size(), 7u);
  std::set<std::string> first;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RunRecord& run = results.runs[rows[i]];
    EXPECT_LE(run.m, 128);
    if (i < 4) first.insert(run.algorithm + run.family);
  }
  EXPECT_EQ(first.size(), 4u) << "one of each curve before a second one of any";
  EXPECT_TRUE(rows_to_show(analysis, 0, 128).empty());
  EXPECT_TRUE(rows_to_show(analysis, 7, 1).empty());

  const ShownDrawings drawings{{{rows[0], 0}}, "AAAA", "'sha256-of-the-viewer'"};
  const auto graphs = rows_by_table(report_tables(analysis, {}, drawings, false))["graphs"];
  EXPECT_EQ(rows_with(graphs, "row", rows[0]).at(0)["drawing"], 0);
  EXPECT_EQ(rows_with(graphs, "drawing", nullptr).size(), graphs.size() - 1);
  const std::string html = render_report(analysis, {}, drawings);
  EXPECT_THAT(html, HasSubstr("id=viewer>AAAA</script>"));
  EXPECT_THAT(html, HasSubstr(" 'sha256-of-the-viewer'; img-src"));
}

}  // namespace
}  // namespace ar3d::testing
