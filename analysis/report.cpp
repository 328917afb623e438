#include "ar3d/analysis/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/page.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d {
namespace {

constexpr const char* kReplayPanel =
    "<div id=tip role=status hidden></div>"
    "<div id=replay role=dialog aria-label='Draw it again' hidden><p></p><code></code>"
    "<button type=button>Copy</button><button type=button id=open hidden>Show in 3D</button>"
    "<button type=button>Close</button></div>\n"
    "<dialog id=shown aria-label='The drawing in 3D'><div><p></p>"
    "<button type=button>Draw it again</button><button type=button>Close</button></div></dialog>\n";

std::string head(const StudyIdentity& study) {
  return "<!doctype html>\n<html lang=en><head><meta charset=utf-8>"
         "<meta name=viewport content='width=device-width,initial-scale=1'>"
         "<meta http-equiv=Content-Security-Policy content=\"default-src 'none'; "
         "style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data: blob:\">"
         "<title>ar3d report: " +
         report::escape(study.study_id) + "</title><style>" + report::page_style() +
         "</style></head>\n";
}

/// The sections in the order of the reader's questions.
std::string body(report::Page& page, const SinceReference& since) {
  const std::vector<report::Section> sections = report::sections(page.analysis);
  const std::string trade = report::trade_section(page, sections);
  const std::string collections = report::collection_sections(page, sections);
  const std::string precision = report::precision_section(page, sections);
  const std::string batches = report::strong_weak_section(page);
  std::string html = report::verdict_section(page, sections, since);
  html += "<nav>";
  const auto link = [&](const std::string& id, const std::string& text) {
    html += "<a href='#" + id + "'>" + text + "</a>";
  };
  if (!sections.empty()) link("closeness", "How close to a bound?");
  if (!trade.empty()) link("trade", "What is traded?");
  if (!collections.empty()) link("c0", "What of the collection?");
  if (!precision.empty()) link("precision", "What does accuracy cost?");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    link(fmt::format("a{}", i), report::escape(sections[i].label));
  }
  link("reference", "What changed?");
  if (!batches.empty()) link("strong-weak", "Strong and weak scaling");
  if (!sections.empty()) link("metrics", "All metrics");
  link("environment", "Environment");
  link("spec", "Specification");
  link("methods", "Methods");
  html += "</nav>\n" + report::closeness_section(page, sections) +
          report::promises_section(sections) + collections + trade + precision;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    html += report::algorithm_section(page, sections[i], fmt::format("a{}", i));
  }
  return html + report::reference_section(since) + batches +
         report::metrics_section(page.analysis, sections) + report::background(page.analysis.rows);
}

/// {"row": which drawing of the viewer's page, …}
std::string drawings_json(const ShownDrawings& drawings) {
  std::string json;
  for (const auto& [row, place] : drawings.page_of_row) {
    json += fmt::format("{}\"{}\":{}", json.empty() ? "" : ",", row, place);
  }
  return "{" + json + "}";
}

}  // namespace

std::vector<Figure> report_figures(const StudyAnalysis& analysis) {
  report::Page page(analysis);
  body(page, {});
  std::vector<Figure> figures;
  for (const report::NamedPlot& plot : page.figures()) {
    figures.push_back({plot.file, report::standalone_svg(plot), plot.csv,
                       report::matplotlib_script(plot), report::pgfplots_document(plot)});
  }
  return figures;
}

std::vector<std::size_t> rows_to_show(const StudyAnalysis& analysis, std::size_t most,
                                      std::int64_t most_edges) {
  std::vector<std::pair<double, std::size_t>> first_rows, other_rows;  // share and row
  for (const CurveTally& curve : analysis.tally.curves) {
    std::vector<std::pair<double, std::size_t>> of_curve;
    for (const auto& [n, graph] : report::worst_by_size(curve)) {
      if (graph->m <= most_edges) of_curve.emplace_back(graph->share(), graph->row);
    }
    if (of_curve.empty()) continue;
    const auto first =
        std::ranges::max_element(of_curve, {}, &std::pair<double, std::size_t>::first);
    first_rows.push_back(*first);
    of_curve.erase(first);
    other_rows.insert(other_rows.end(), of_curve.begin(), of_curve.end());
  }
  std::vector<std::size_t> rows;
  const auto add = [&](std::size_t row) {
    if (rows.size() < most && std::ranges::find(rows, row) == rows.end()) rows.push_back(row);
  };
  for (const Finding& finding : analysis.verdict.findings) {
    if (finding.row && rows.size() < report::kShownFindings) add(*finding.row);
  }
  for (const std::size_t row : report::collection_outliers(report::sections(analysis))) {
    if (rows.size() < most && analysis.rows.read(row).m <= most_edges) add(row);
  }
  for (auto* shares : {&first_rows, &other_rows}) {
    std::ranges::stable_sort(*shares, std::greater(), &std::pair<double, std::size_t>::first);
    for (const auto& [share, row] : *shares) add(row);
  }
  return rows;
}

std::string render_report(const StudyAnalysis& analysis, const SinceReference& since,
                          const ShownDrawings& drawings) {
  report::Page page(analysis, drawings);
  std::string html = head(*analysis.rows.identity) + "<body>\n" + body(page, since) + kReplayPanel;
  const auto data = [&](const char* id, const std::string& json) {
    html += fmt::format("<script type='application/json' id={}>{}</script>\n", id, json);
  };
  data("rows", page.rows_json());
  data("figures", page.figures_json());
  data("drawings", drawings_json(drawings));
  html += "<script type='text/plain' id=viewer>" + drawings.packed_page + "</script>\n";
  data("figure-style", report::json_string(report::figure_style()));
  return html + "<script>" + report::table_script() + report::page_script() +
         "</script>\n</body></html>\n";
}

}  // namespace ar3d
