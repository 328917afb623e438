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

/// The sections in the order of the reader's questions.
std::string body(report::Page& page) {
  const std::vector<report::Section> sections = report::sections(page.analysis);
  const std::string trade = report::trade_section(page, sections);
  const std::string batches = report::strong_weak_section(page);
  std::string html = report::verdict_section(page.analysis);
  html += "<nav>";
  const auto link = [&](const std::string& id, const std::string& text) {
    html += "<a href='#" + id + "'>" + text + "</a>";
  };
  if (!sections.empty()) link("closeness", "How close to a bound?");
  if (!trade.empty()) link("trade", "What is traded?");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    link(fmt::format("a{}", i), report::escape(sections[i].label));
  }
  if (!batches.empty()) link("strong-weak", "Strong and weak scaling");
  if (!sections.empty()) link("metrics", "All metrics");
  link("environment", "Environment");
  link("spec", "Specification");
  link("methods", "Methods");
  html += "</nav>\n" + report::closeness_section(page, sections) + trade;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    html += report::algorithm_section(page, sections[i], fmt::format("a{}", i));
  }
  return html + batches + report::metrics_section(page.analysis, sections) +
         report::background(page.analysis.rows);
}

}  // namespace

std::vector<Figure> report_figures(const StudyAnalysis& analysis) {
  report::Page page(analysis);
  body(page);
  std::vector<Figure> figures;
  for (const report::NamedPlot& plot : page.figures()) {
    figures.push_back({plot.file, report::standalone_svg(plot), plot.csv,
                       report::matplotlib_script(plot), report::pgfplots_document(plot)});
  }
  return figures;
}

std::string render_report(const StudyAnalysis& analysis) {
  report::Page page(analysis);
  std::string html = head(*analysis.rows.identity) + "<body>\n" + body(page) + kReplayPanel;
  const auto data = [&](const char* id, const std::string& json) {
    html += fmt::format("<script type='application/json' id={}>{}</script>\n", id, json);
  };
  data("rows", page.rows_json());
  data("figures", page.figures_json());
  data("figure-style", report::json_string(report::figure_style()));
  return html + "<script>" + report::page_script() + "</script>\n</body></html>\n";
}

}  // namespace ar3d
