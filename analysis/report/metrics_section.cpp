// Every metric of verify/metrics/metrics.h in one table, whatever metrics there are.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

/// The kept graphs of one setting at its largest n.
struct LargestGraphs {
  std::string label;
  std::int64_t n = -1;
  std::vector<const DrawnGraph*> graphs;
};

std::vector<LargestGraphs> largest_graphs(const StudyTally& tally,
                                          const std::vector<Section>& sections) {
  std::vector<LargestGraphs> all;
  for (const Section& section : sections) all.push_back({section.label, -1, {}});
  for (const CurveTally& curve : tally.curves) {
    const std::string label = algorithm_label(curve.key);
    LargestGraphs& largest = *std::find_if(
        all.begin(), all.end(), [&](const LargestGraphs& one) { return one.label == label; });
    for (const auto& [n, size] : curve.sizes) {
      if (size.drawn == 0 || n < largest.n) continue;
      if (n > largest.n) largest.graphs.clear();
      largest.n = n;
      for (const DrawnGraph& graph : size.graphs) largest.graphs.push_back(&graph);
    }
  }
  return all;
}

std::string value_cell(std::size_t metric, const LargestGraphs& largest) {
  std::vector<double> values;
  for (const DrawnGraph* graph : largest.graphs) {
    if (!std::isnan(graph->metrics[metric])) values.push_back(graph->metrics[metric]);
  }
  if (values.empty()) return cell("–", true);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const std::string range = fmt::format("{:.4g} – {:.4g}", *least, *most);
  return cell(fmt::format("{:.4g} <small>{}</small>", median(values), range), true);
}

}  // namespace

std::string metrics_section(const StudyAnalysis& analysis, const std::vector<Section>& sections) {
  if (sections.empty()) return "";
  const std::vector<LargestGraphs> settings = largest_graphs(analysis.tally, sections);
  std::string html =
      "<section id=metrics><h2>All metrics</h2><p>Median and (grey) least and largest value over "
      "the graphs of the largest n that was drawn; definitions are those of <code>ar3d list "
      "metrics</code>.</p><div class=scroll><table "
      "class=sortable><thead><tr><th>Metric<th>Unit<th>Definition";
  for (const LargestGraphs& graphs : settings) {
    html += fmt::format("<th class=num>{}<br>n = {}", escape(graphs.label),
                        graphs.n < 0 ? "–" : grouped(graphs.n));
  }
  html += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < metrics().size(); ++i) {
    const Metric& metric = metrics()[i];
    html += fmt::format("<tr><th scope=row>{}</th>", escape(metric.name)) +
            cell(escape(metric.unit)) + note(escape(metric.definition));
    for (const LargestGraphs& graphs : settings) html += value_cell(i, graphs);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div></section>\n";
}

}  // namespace ar3d::report
