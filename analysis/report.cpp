#include "ar3d/analysis/report.h"

#include <fmt/format.h>

#include "ar3d/analysis/report/figures.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/page_files.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d {
namespace {

constexpr const char* kReplayPanel =
    "<div id=tip role=status hidden></div><div id=replay role=dialog aria-label='Draw it again' "
    "hidden>"
    "<p></p><code></code><button type=button>Copy</button><button "
    "type=button>Close</button></div>\n";

std::string head(const StudyIdentity& study) {
  return "<!doctype html>\n<html lang=en><head><meta charset=utf-8>"
         "<meta name=viewport content='width=device-width,initial-scale=1'>"
         "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; "
         "style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">"
         "<title>ar3d report: " +
         report::escape(study.study_id) + "</title><style>" + report::page_style() +
         "</style></head>\n";
}

}  // namespace

std::vector<Figure> report_figures(const StudyAnalysis& analysis) {
  return report::standalone_figures(analysis);
}

std::string render_report(const StudyAnalysis& analysis) {
  const std::vector<report::Section> sections = report::sections(analysis);
  std::string html =
      head(*analysis.rows.identity) + "<body>\n" + report::overview(analysis, sections);
  const std::string effort = report::effort_section(analysis);
  const std::string batches = report::strong_weak_section(analysis);
  html += fmt::format(
      "<nav>{}{}<a href='#metrics'>Metrics</a><a href='#methods'>Methods</a><a "
      "href='#environment'>Environment</a>"
      "<a href='#spec'>Specification</a></nav>\n",
      effort.empty() ? "" : "<a href='#effort'>What a smaller box costs</a>",
      batches.empty() ? "" : "<a href='#strong-weak'>Strong and weak scaling</a>");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    html += report::algorithm_section(sections[i], fmt::format("a{}", i));
  }
  html += effort + batches + report::metrics_section(analysis, sections) +
          report::background(analysis.rows) + kReplayPanel;
  html += "<script type='application/json' id=rows>" + report::plotted_rows_json(analysis) +
          "</script>\n<script>" + report::page_script() + "</script>\n";
  return html + "</body></html>\n";
}

}  // namespace ar3d
