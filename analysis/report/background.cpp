// What stands behind the numbers: every metric whatever metrics there are, environment,
// specification, methods.
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

constexpr const char* kMethods =
    R"html(<section id=methods><h2>Methods</h2><details><summary>How it was measured and judged</summary>
<p><b>Certificate.</b> A row counts as proved only if its drawing was checked in exact integers by code that shares nothing
with the code that drew it: edge set, directions, bends, all angles, coinciding points, crossings, and the size against the
theorem. A row with another certificate (column certificate: measured, none; in older results also filtered, double, a sample) counts as not proved, and
no violation in it only says that none was looked for or found.</p>
<p><b>Bounds.</b> Extents are largest minus smallest coordinate. The theorem's bound depends on n alone; a graph's own
bound is what the proof gives for that very graph; a published bound is somebody else's and only compared (where the source gives an
order without a constant, 1 stands for it). Fill is extent over bound, worst and median over graphs (one
repetition each, since repetitions must give the same drawing).</p>
<p><b>Volume.</b> The number of lattice points in the box, the product of extent + 1 over the axes.</p>
<p><b>Exponents.</b> Logarithms of the values, averaged over the graphs of each size (over repetitions the median),
fitted by least squares against log n, every size with the same weight. Sizes below the square root of the largest n
are left out while eight stay; a size with an unfinished graph is left out, because its finished ones are the fast ones.
With fewer than eight sizes, or sizes less than four-fold apart, the answer is “undecided”.</p>
<p><b>Intervals.</b> 95 %. A size is a cluster: its graphs may share an error. Cluster-robust variance (HC2 on the means of
the sizes) with Student's t and the degrees of freedom of Bell and McCaffrey (Imbens and Kolesár 2016).</p>
<p><b>Labels.</b> “Power law”: sizes at least 16-fold apart, the drift of the local exponent from the smallest to the
largest size lies within ±0.1 with 95 % confidence, and a test of fit for quadratic and cubic terms (10 %) does not reject the line, or
the sizes are off it by less than 1 %. “With logarithm”: sizes at least 100-fold apart, the local exponent falls, the interval of b in
n^a·log^b n holds 1, 2 or 3 and not 0, and an Akaike weight of at least 0.95 against n^a alone, with a lower-order term, or with
a step. Everything else is an “apparent exponent”: true of the sizes it was fitted to, and of no others.</p>
<p><b>Times.</b> Wall time of the drawing alone, without generating, certifying or writing. Only times of the timing phase are
fitted, where a drawing has a core of its own; other rows ran beside others.</p>
<p><b>Unfinished rows.</b> A timeout, a crash or exhausted memory is a value that is only known to be large: such rows stand as
red points at the upper edge of their figures, and their size is left out of the fit.</p>
<p><b>Growth figures.</b> Every value is divided by the order of the theorem's bound (times by n), so that growth in that order is a
horizontal line and anything else a slope. Band and thick line: least, median and largest of the families' medians at the n that was asked
for. Thin lines: medians of a family at its own n; drawn are the two with the largest and the two with the least last values, and
those that “Highlight families” picks. Points: graphs, evenly over the sorted values.</p>
<p><b>Trade.</b> As many settings as have a family in common are compared, over the families that all of these drew at that n. A crossing is where the medians of two algorithms' settings,
joined in logarithms, meet for the last time.</p>
<p><b>Saving.</b> Every figure can be saved as SVG and CSV, with a matplotlib script or a LaTeX document (pgfplots) that draws the CSV, which lies beside
it; <code>ar3d report --figures DIR</code> writes all of them, and PDF.</p></details></section>
)html";

}  // namespace

std::string metrics_section(const StudyAnalysis& analysis, const std::vector<Section>& sections) {
  if (sections.empty()) return "";
  const std::vector<LargestGraphs> settings = largest_graphs(analysis.tally, sections);
  std::vector<std::string> columns = {"Metric", "Unit", "Definition"};
  for (const LargestGraphs& graphs : settings) {
    columns.push_back(
        fmt::format("#{}<br>n = {}", escape(graphs.label), graphs.n < 0 ? "–" : grouped(graphs.n)));
  }
  std::string html =
      "<section id=metrics><h2>All metrics</h2><p>Median and (grey) least and largest value over "
      "the graphs of the largest n that was drawn; definitions are those of <code>ar3d list "
      "metrics</code>.</p><details><summary>The table</summary>" +
      table_head(columns);
  for (std::size_t i = 0; i < metrics().size(); ++i) {
    const Metric& metric = metrics()[i];
    html += row_head(metric.name) + cell(escape(metric.unit)) + note(escape(metric.definition));
    for (const LargestGraphs& graphs : settings) html += value_cell(i, graphs);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div></details></section>\n";
}

std::string background(const RowView& rows) {
  const StudyIdentity& study = *rows.identity;
  std::string html = "<section id=environment><h2>Environment</h2>";
  if (rows.environment->empty()) {
    html += "<p>The file names none.</p>";
  } else {
    html += "<div class=scroll><table><tbody>";
    for (const EnvironmentEntry& entry : *rows.environment) {
      html += row_head(entry.name) + note(escape(entry.value)) + "</tr>";
    }
    html += "</tbody></table></div>";
  }
  html += "</section>\n<section id=spec><h2>Specification</h2><p class=muted>XXH3-128 " +
          escape(study.spec_hash) + "</p><pre tabindex=0>" + escape(study.spec) +
          "</pre></section>\n";
  return html + kMethods;
}

}  // namespace ar3d::report
