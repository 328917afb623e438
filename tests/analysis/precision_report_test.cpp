// What a report says of drawings in real types, of certificate modes and of levels.
#include <cmath>
#include <limits>
#include <memory>

#include "analysis/synthetic.h"
#include "ar3d/analysis/report.h"
#include "ar3d/analysis/report/precision.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d::testing {
namespace {

using report::judge_onset;
using report::OnsetVerdict;

constexpr int kBits[] = {24, 53, 64, 113, 237};
constexpr double kDegrees = 57.29577951308232;

/// A drawing whose condition is n^2 and whose miss is `kappa` of what that allows.
RunRecord real_run(int type, std::int64_t n, std::int64_t instance, double kappa,
                   const std::string& family = "random-cubic") {
  RunRecord run = good_run("two-bend-paper", family, n, instance);
  run.options = "type=" + std::to_string(type);
  run.certificate = "measured";
  run.theorem_bound = {kMissing, kMissing, kMissing};
  run.cpu_s = 1e-6 * static_cast<double>(n) * (type + 1);
  auto real = std::make_shared<RealAssessment>();
  real->angles = 4;
  real->condition = static_cast<double>(n) * static_cast<double>(n);
  real->largest_miss = kappa * kDegrees * std::ldexp(real->condition, -kBits[type]);
  real->within = {1, 2, 3, 4};
  DrawingSummary summary;
  summary.real = std::move(real);
  set_metrics(summary, run);
  return run;
}

/// Five types, n = 16, 32, …, 4096, three graphs each; kappa of one type as told, else 0.2.
Results real_results(int other_type = -1, double other_kappa = 0.2) {
  Results results = good_results({}, {}, 0, 0);
  for (std::int64_t n = 16; n <= 4096; n *= 2) {
    for (int type = 0; type < 5; ++type) {
      for (std::int64_t i = 0; i < 3; ++i) {
        results.runs.push_back(real_run(type, n, i, type == other_type ? other_kappa : 0.2));
      }
    }
  }
  return results;
}

/// The section of the page.
std::string section_of(const Results& results) {
  const std::string html = report_of(results);
  const std::size_t begin = html.find("<section id=precision>");
  if (begin == std::string::npos) return "";
  return html.substr(begin, html.find("</section>", begin) - begin);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(PrecisionReport, PredictsEveryTypeFromTheWidest) {
  const std::string html = report_of(real_results());
  EXPECT_THAT(html, HasSubstr("<section id=precision>"));
  EXPECT_THAT(html, HasSubstr("<a href='#precision'>What does accuracy cost?</a>"));
  EXPECT_THAT(html, HasSubstr("135 drawings in real types"));
  EXPECT_THAT(html, HasSubstr("0 of them are broken"));
  EXPECT_THAT(html, HasSubstr("From 27 drawings in 237 bits: κ has the median 0.2"));
  // 0.2 * 57.3 * 2^-24 n^2 = 10^-3 at n = 38; 10^-9 in double at n = 886.
  EXPECT_THAT(html, HasSubstr("float passes 10<sup>-3</sup> degrees on random-cubic at n = 38; "
                              "predicted at n = 38: <span class=pass>confirmed</span>."));
  EXPECT_THAT(html, HasSubstr("double passes 10<sup>-9</sup> degrees on random-cubic at n = 887; "
                              "predicted at n = 887: <span class=pass>confirmed</span>."));
  EXPECT_THAT(html, Not(HasSubstr(">refuted</b>")));
  for (const char* figure : {"miss", "miss-in-roundings", "accuracy-against-time", "onsets"}) {
    EXPECT_EQ(count(html, "<figure data-fig='" + std::string(figure) + "'"), 1u) << figure;
  }
  EXPECT_THAT(html, HasSubstr("<polygon class='band f0'"));
  EXPECT_THAT(html, HasSubstr("25.0 % <small>· 0.0 %</small>")) << "one of four angles";
  EXPECT_THAT(html, HasSubstr("100.0 % <small>· 100.0 %</small>"));
}

TEST(PrecisionReport, SaysWhichPredictionsAreRefuted) {
  const std::string html = report_of(real_results(1, 0.2 * 25));
  // A miss 25 times as large passes every limit at a fifth of n.
  EXPECT_THAT(
      html,
      HasSubstr("double passes 10<sup>-9</sup> degrees on random-cubic at n = 177; "
                "predicted at n = 887: <b class=violated>refuted</b>. κ is 5 there, and 0.2 in"));
  EXPECT_THAT(html, HasSubstr("float passes 10<sup>-3</sup> degrees on random-cubic at n = 38; "
                              "predicted at n = 38: <span class=pass>confirmed</span>."));
}

TEST(PrecisionReport, WhatLiesBeyondTheSizesIsOpenUnlessItIsFar) {
  constexpr double kBeyond = std::numeric_limits<double>::infinity();
  const auto verdict = [](double predicted, double seen) {
    return judge_onset({"f", 0, -9, predicted, seen, 1, 3, OnsetVerdict::open});
  };
  EXPECT_EQ(verdict(2, 2.3), OnsetVerdict::confirmed);
  EXPECT_EQ(verdict(2, 2.302), OnsetVerdict::refuted);
  EXPECT_EQ(verdict(2.302, 2), OnsetVerdict::refuted);
  EXPECT_EQ(verdict(kBeyond, 2.8), OnsetVerdict::open) << "less than twice as large";
  EXPECT_EQ(verdict(kBeyond, 2.6), OnsetVerdict::refuted) << "at least 2.5 times as large";
  EXPECT_EQ(verdict(2.8, kBeyond), OnsetVerdict::open);
  EXPECT_EQ(verdict(2.6, kBeyond), OnsetVerdict::refuted);
  EXPECT_EQ(verdict(-kBeyond, 1.2), OnsetVerdict::open);
  EXPECT_EQ(verdict(1.4, -kBeyond), OnsetVerdict::refuted);
  EXPECT_EQ(verdict(-kBeyond, kBeyond), OnsetVerdict::refuted);
}

TEST(PrecisionReport, DrawingsThatMissNothingAndBrokenOnes) {
  Results results = real_results();
  for (RunRecord& run : results.runs) {
    if (run.options != "type=0" || run.n > 32) continue;
    const std::int64_t n = run.n;
    run = real_run(0, n, run.instance_index, 0);
    if (n == 16) continue;
    DrawingSummary summary;
    auto real = std::make_shared<RealAssessment>();
    real->angles = 1;
    real->largest_miss = 30;
    real->condition = 1e3;
    real->collapsed = 1;
    summary.real = std::move(real);
    set_metrics(summary, run);
  }
  const std::string html = section_of(results);
  EXPECT_THAT(html, HasSubstr("3 of them are broken"));
  EXPECT_EQ(count(html, "<path class='cut' d="), 2u * 3) << "in both figures";
  EXPECT_THAT(html, Not(HasSubstr("nan")));
  EXPECT_THAT(html, Not(HasSubstr("inf")));
}

TEST(PrecisionReport, OneTypeAloneIsShownAndPredictsNothing) {
  Results results = real_results();
  std::erase_if(results.runs, [](const RunRecord& run) { return run.options != "type=1"; });
  const std::string html = report_of(results);
  EXPECT_THAT(html, HasSubstr("<figure data-fig='miss'"));
  EXPECT_THAT(html, Not(HasSubstr("<figure data-fig='onsets'")));
}

TEST(PrecisionReport, CertificateModesAndLevels) {
  Results results = good_results({"diamond"}, {"cubic"}, 2, 3);
  EXPECT_THAT(report_of(results), Not(HasSubstr("<section id=precision>")));
  const std::size_t exact = results.runs.size();
  for (std::size_t i = 0; i < exact; ++i) {
    RunRecord run = results.runs[i];
    run.certificate = "filtered";
    run.certify_s = 32e-6;
    run.instance_index += 10;
    run.graph_hash += "f";
    results.runs.push_back(run);
  }
  const std::string modes = report_of(results);
  EXPECT_THAT(modes, HasSubstr("<h3>Certificate modes</h3>"));
  EXPECT_THAT(modes, HasSubstr("<td>filtered</td><td class=num>3</td><td class=num>0</td>"
                               "<td class=num>2 µs "));
  EXPECT_THAT(modes, Not(HasSubstr("<h3>Levels of detail</h3>")));

  results = good_results({"diamond"}, {"cubic"}, 2, 3);
  for (std::size_t i = 0; i < exact; ++i) {
    RunRecord run = results.runs[i];
    run.level = "full";
    run.store_s = 16e-6;
    run.peak_scope = "worker";
    run.base_bytes = 1000;
    run.peak_bytes = 1000 + 100 * run.n;
    results.runs.push_back(run);
  }
  const std::string levels = report_of(results);
  EXPECT_THAT(levels, HasSubstr("<h3>Levels of detail</h3>"));
  EXPECT_THAT(levels, HasSubstr("<td>full</td><td class=num>3</td>"));
  EXPECT_THAT(levels, HasSubstr("<td class=num>100</td></tr>"));
}

TEST(PrecisionReport, EffortsAreComparedWithTheFirst) {
  Results results = good_results({"diamond"}, {"cubic"}, 2, 3);
  const std::size_t first = results.runs.size();
  for (std::size_t i = 0; i < first; ++i) {
    results.runs[i].options = "effort=0";
    RunRecord run = results.runs[i];
    run.options = "effort=1";
    run.wall_s *= 10;
    run.log2_volume -= 1;
    results.runs.push_back(run);
    run = results.runs[i];
    run.level = "full";
    results.runs.push_back(run);
  }
  const std::vector<Figure> figures = report_figures(analyse(view_of(results)));
  const auto at = std::find_if(figures.begin(), figures.end(),
                               [](const Figure& figure) { return figure.name == "effort"; });
  ASSERT_NE(at, figures.end());
  EXPECT_THAT(at->csv, HasSubstr("diamond (effort=1),point,10,0.5,,"));
}

TEST(PrecisionReport, TypesAreThoseOfTheAlgorithm) {
  const auto name = [](const std::string& algorithm, const std::string& options) {
    return report::real_setting({algorithm, options, "", "", ""}).name;
  };
  EXPECT_EQ(name("two-bend-paper", "type=0"), "float");
  EXPECT_EQ(name("two-bend-paper", "type=4"), "237 bits");
  EXPECT_EQ(name("two-bend-paper", "type=5"), "two-bend-paper (type=5)");
  EXPECT_EQ(name("mine", "type=0"), "mine (type=0)");
  EXPECT_EQ(report::real_setting({"mine", "", "", "", ""}).bits, 0);
}

}  // namespace
}  // namespace ar3d::testing
