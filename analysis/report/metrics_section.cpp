// Every metric of verify/metrics.h in one table, whatever metrics there are.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/records/run_columns.h"

namespace ar3d::report {
namespace {

/// The graphs of one setting at its largest n: the first ok row of each.
struct LargestGraphs {
  std::string label;
  std::int64_t n = -1;
  std::vector<const RunRecord*> runs;
};

std::vector<LargestGraphs> largest_graphs(const Analysis& analysis,
                                          const std::vector<Section>& sections) {
  std::vector<LargestGraphs> all;
  for (const Section& section : sections) all.push_back({section.label, -1, {}});
  for (const Cell& cell : cells(analysis.results)) {
    const std::string label = algorithm_label(cell.key);
    LargestGraphs& graphs = *std::find_if(
        all.begin(), all.end(), [&](const LargestGraphs& one) { return one.label == label; });
    for (const InstanceRows& instance : cell.instances) {
      const RunRecord* run = first_ok(analysis.results, instance);
      if (run == nullptr || instance.n < graphs.n) continue;
      if (instance.n > graphs.n) graphs.runs.clear();
      graphs.n = instance.n;
      graphs.runs.push_back(run);
    }
  }
  return all;
}

std::string value_cell(const Column& metric, const LargestGraphs& graphs) {
  std::vector<double> values;
  for (const RunRecord* run : graphs.runs) {
    const double value = column_number(metric, *run);
    if (!std::isnan(value)) values.push_back(value);
  }
  if (values.empty()) return cell("–", true);
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const std::string range = fmt::format("{:.4g} – {:.4g}", *least, *largest);
  return cell(fmt::format("{:.4g} <small>{}</small>", median(values), range), true);
}

}  // namespace

std::string metrics_section(const Analysis& analysis, const std::vector<Section>& sections) {
  if (sections.empty()) return "";
  const std::vector<LargestGraphs> settings = largest_graphs(analysis, sections);
  std::string html =
      "<section id=metrics><h2>All metrics</h2><p>Median and (grey) least and largest value over "
      "the graphs of the largest n that was drawn; definitions are those of <code>ar3d list "
      "metrics</code>.</p><div class=scroll><table><thead><tr><th>Metric<th>Unit<th>Definition";
  for (const LargestGraphs& graphs : settings) {
    html += fmt::format("<th class=num>{}<br>n = {}", escape(graphs.label),
                        graphs.n < 0 ? "–" : grouped(graphs.n));
  }
  html += "</tr></thead><tbody>\n";
  for (const Column& metric : columns_of_kind(ColumnKind::metric)) {
    html += fmt::format("<tr><th scope=row>{}</th>", escape(metric.name)) +
            cell(escape(metric.unit)) + note(escape(metric.meaning));
    for (const LargestGraphs& graphs : settings) html += value_cell(metric, graphs);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div></section>\n";
}

}  // namespace ar3d::report
