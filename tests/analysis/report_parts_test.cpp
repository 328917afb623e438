// What a report shows beside its study: changes since a reference, and drawings.
#include <fmt/format.h>

#include <set>

#include "analysis/synthetic.h"
#include "ar3d/analysis/report.h"

namespace ar3d::testing {
namespace {

/// The page of `now`, compared with `base`; without its scripts.
std::string page_since(const Results& base, const Results& now) {
  const SinceReference since{"0.1.0-base.h5", "long ago", compare(base, now), ""};
  const std::string html = render_report(analyse(view_of(now)), since);
  return html.substr(0, html.find("<script"));
}

TEST(ReportParts, SaysWhatChangedSinceTheReference) {
  const Results base = good_results({"diamond"}, {"cubic", "prism"}, 9, 4);
  const std::string alike = page_since(base, base);
  EXPECT_THAT(alike, HasSubstr("Since the reference <a href='#reference'>0.1.0-base.h5</a>: "
                               "<b>PASS</b>"));
  EXPECT_THAT(alike, HasSubstr("The two hold the same measurements."));
  EXPECT_THAT(alike, Not(HasSubstr("Where something changed")));

  Results now = base;
  for (RunRecord& run : now.runs) {
    run.wall_s *= 1.001;
    if (run.family == "prism" && run.n == 64) run.extents[1] *= 2;
    if (run.family == "prism" && run.n == 64) run.log2_volume += 1;
  }
  const std::string worse = page_since(base, now);
  EXPECT_THAT(worse, HasSubstr("<b>REGRESSED</b> against 0.1.0-base.h5 of long ago"));
  EXPECT_THAT(worse, HasSubstr("Where something changed (1)"));
  EXPECT_THAT(worse, HasSubstr("<td>REGRESSED</td><th scope=row>diamond</th><td>prism, n = 64"));

  now.environment.push_back({"flags", "-O0", 0});
  const std::string unlike = page_since(base, now);
  EXPECT_THAT(unlike, HasSubstr("The environments differ, so times are shown and not judged"));
  EXPECT_THAT(unlike, HasSubstr("<li>flags: absent → -O0</li>"));

  now.environment = {{"load_before", "9.00", 0}};
  Results busy = base;
  busy.environment = now.environment;
  const std::string busy_page = page_since(busy, now);
  EXPECT_THAT(busy_page, HasSubstr("The machine was busy with other work, so times are shown"));
  EXPECT_THAT(busy_page, HasSubstr("<li>load of other work: 9.00 in both</li>"));
  EXPECT_THAT(summary(compare(busy, now), {}), StartsWith("BUSY MACHINE: times are shown, but"));

  const std::string alone = report_of(base);
  EXPECT_THAT(alone, HasSubstr("Not compared: No reference was given."));
  EXPECT_THAT(alone, Not(HasSubstr("Since the reference")));
}

TEST(ReportParts, StoresTheGraphsThatComeClosestFirst) {
  const Results results = good_results({"diamond", "grid"}, {"cubic", "prism"}, 5, 2);
  const StudyAnalysis analysis = analyse(view_of(results));
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

  const std::string html = render_report(analysis, {}, {{{rows[0], 0}}, "AAAA"});
  EXPECT_THAT(html, HasSubstr(fmt::format(" shown' data-r={} ", rows[0])));
  EXPECT_EQ(html.find(" shown' data-r="), html.rfind(" shown' data-r="));
  EXPECT_THAT(html, HasSubstr("id=viewer>AAAA</script>"));
}

}  // namespace
}  // namespace ar3d::testing
