// The tables of a study, and the page that shows them: a template of the tree with tables, style and
// scripts put in.
#include "ar3d/analysis/report/report.h"

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d_page_files.h"

namespace ar3d {
namespace {

/// Text of an element: markup in it is none, and control characters are spaces.
std::string escaped(std::string_view text) {
  std::string safe = one_line(text);
  boost::algorithm::replace_all(safe, "&", "&amp;");
  boost::algorithm::replace_all(safe, "<", "&lt;");
  boost::algorithm::replace_all(safe, ">", "&gt;");
  return safe;
}

void append(std::span<const std::string_view> pieces, std::string& text) {
  for (const std::string_view piece : pieces) text += piece;
}

std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

}  // namespace

std::string render_page(std::string_view page, std::string_view title,
                        const std::vector<Table>& tables, const ShownDrawings& drawings) {
  const bool is_report = page == "report";
  std::string html;
  std::string_view rest = is_report ? kReportTemplate : kHistoryTemplate;
  for (std::size_t at = rest.find("{{"); at != rest.npos; at = rest.find("{{")) {
    html += rest.substr(0, at);
    const std::size_t end = rest.find("}}", at);
    const std::string_view name = rest.substr(at + 2, end - at - 2);
    rest.remove_prefix(end + 2);
    if (name == "title") {
      html += escaped(title);
    } else if (name == "hashes") {
      html.append(is_report ? kReportHash : kHistoryHash).append(" ").append(kPlotHash);
      if (!drawings.script_hashes.empty()) html.append(" ").append(drawings.script_hashes);
    } else if (name == "style") {
      html += kPageStyle;
    } else if (name == "tables") {
      html += tables_json(tables);
    } else if (name == "viewer") {
      html += drawings.packed_page;
    } else if (name == "script") {
      append(is_report ? std::span<const std::string_view>(kReportScript) : kHistoryScript, html);
    } else {
      expect(name == "plot", "a template names what there is");
      append(kPlotScript, html);
    }
  }
  return html.append(rest);
}

std::vector<Table> report_tables(const StudyAnalysis& analysis, const SinceReference& since,
                                 const ShownDrawings& drawings, bool all) {
  const std::vector<report::Section> sections = report::sections(analysis);
  report::TableMaker make{analysis, since, sections, all};
  report::add_verdict(make);
  report::add_background(make);
  report::add_families(make);
  report::add_curves(make);
  report::add_trade(make);
  report::add_collections(make);
  report::add_precision(make);
  make.fill_graphs(drawings.page_of_row);
  return std::move(make.tables);
}

std::string render_report(const StudyAnalysis& analysis, const SinceReference& since,
                          const ShownDrawings& drawings) {
  return render_page("report", analysis.rows.identity().study_id,
                     report_tables(analysis, since, drawings, false), drawings);
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
    if (rows.size() < most && analysis.rows.run(row).m <= most_edges) add(row);
  }
  for (auto* shares : {&first_rows, &other_rows}) {
    std::ranges::stable_sort(*shares, std::greater(), &std::pair<double, std::size_t>::first);
    for (const auto& [share, row] : *shares) add(row);
  }
  return rows;
}

std::string bounds_csv(const StudyAnalysis& analysis) {
  std::vector<Table> tables = empty_tables("report");
  report::fill_bounds(analysis, report::sections(analysis), table_named("bounds", tables));
  return table_csv(table_named("bounds", tables));
}

std::string scaling_csv(const StudyAnalysis& analysis) {
  std::vector<Table> tables = empty_tables("report");
  report::fill_growth(analysis, report::sections(analysis), table_named("growth", tables));
  return table_csv(table_named("growth", tables));
}

void rows_csv(const Rows& rows, const TextSink& write) {
  std::string csv =
      "row,key,algorithm,options,family,parameters,graph_name,group,instance,n,m,seed,status,"
      "certificate";
  for (const Metric& metric : metrics()) csv += "," + metric.name;
  for (const char* box : {"instance_bound", "theorem_bound", "published_bound", "slack"}) {
    for (const char axis : {'x', 'y', 'z'}) csv += fmt::format(",{}_{}", box, axis);
  }
  write(csv + "\r\n");
  const auto integer = [](std::int64_t value) { return value < 0 ? "" : std::to_string(value); };
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const RunRecord& run = rows.run(row);
    std::vector<std::string> fields = {std::to_string(row),
                                       run.row_key,
                                       csv_field(run.algorithm),
                                       csv_field(options_and_level(curve_of(run))),
                                       csv_field(run.family),
                                       csv_field(run.parameters),
                                       csv_field(run.graph_name),
                                       csv_field(run.group),
                                       integer(run.instance_index),
                                       integer(run.n),
                                       integer(run.m),
                                       std::to_string(run.seed),
                                       to_string(run.status),
                                       csv_field(run.certificate)};
    for (const MetricValue& metric : metrics_of(run)) {
      const auto text = [](auto value) { return fmt::format("{}", value); };
      fields.push_back(std::isnan(number_of(metric)) ? "" : std::visit(text, metric));
    }
    for (const std::int64_t bound : run.instance_bound) fields.push_back(integer(bound));
    std::array<double, 3> slack{};
    for (std::size_t i = 0; i < 3; ++i) slack[i] = slack_of(run.extents[i], run.theorem_bound[i]);
    for (const auto& values : {run.theorem_bound, run.published_bound, slack}) {
      for (const double value : values) fields.push_back(field(value));
    }
    write(fmt::format("{}\r\n", fmt::join(fields, ",")));
  }
}

std::string analysis_json(const StudyAnalysis& analysis, const SinceReference& since) {
  return tables_json(report_tables(analysis, since, {}, true));
}

}  // namespace ar3d
