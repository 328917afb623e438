// What drawings in real types miss: figures and tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/precision.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostPoints = 3000;  // of drawings in one figure

/// The kept graphs, with their curves, by row: what the page's script can point at.
using GraphsByRow = std::map<std::size_t, std::pair<std::size_t, const DrawnGraph*>>;

GraphsByRow graphs_by_row(const StudyTally& tally) {
  GraphsByRow graphs;
  for (std::size_t curve = 0; curve < tally.curves.size(); ++curve) {
    for (const auto& [n, size] : tally.curves[curve].sizes) {
      for (const DrawnGraph& graph : size.graphs) graphs[graph.row] = {curve, &graph};
    }
  }
  return graphs;
}

/// One line and its points in units that the figure chooses.
struct MissLine {
  std::size_t setting = 0;
  std::map<std::int64_t, double> medians;
  double shift = 0;  ///< added to every logarithm
};

std::string cross(double x, double y) {
  return fmt::format("<path class='cut' d='M{:.1f} {:.1f}l8 8m0 -8l-8 8' fill='none'/>", x - 4,
                     y - 4);
}

/// Points of the rows of one line: dots, and a cross where a drawing is broken.
std::string points_svg(Page& page, const GraphsByRow& graphs, const RealRows& real,
                       const std::string& family, const MissLine& line, const PlotFrame& frame,
                       NamedPlot& plot) {
  static constexpr const char* kBroken = " broken";
  Dots dots;
  std::string crosses;
  std::size_t shown = 0;
  for (const RealRow& row : real.rows) {
    if (row.setting != line.setting || row.family != family) continue;
    if (!std::isfinite(row.log_miss) || ++shown > kMostPoints) continue;
    const double log_n = log10_of(row.n), value = row.log_miss + line.shift;
    const double x = frame.x.pixel(log_n), y = frame.y.pixel(value);
    const std::string& name = real.settings[row.setting].name;
    plot.csv += csv_line(row.is_broken ? name + kBroken : name, "point", log_n, value);
    if (row.is_broken) crosses += cross(x, y);
    const auto at = graphs.find(row.row);
    if (at != graphs.end()) dots.add(x, y, page.point_at(at->second.first, *at->second.second));
  }
  return dots.svg("points " + stroke_class(line.setting)) + crosses;
}

std::string median_svg(const RealRows& real, const MissLine& line, const PlotFrame& frame,
                       NamedPlot& plot) {
  std::string points;
  for (const auto& [n, log_miss] : line.medians) {
    if (!std::isfinite(log_miss)) continue;
    points += frame.point(log10_of(n), log_miss + line.shift);
    plot.csv += csv_line(real.settings[line.setting].name + " median", "line", log10_of(n),
                         log_miss + line.shift);
  }
  return fmt::format("<polyline class='median {}' points='{}'/>", stroke_class(line.setting),
                     points);
}

Label label_of(const RealRows& real, const MissLine& line, const PlotFrame& frame) {
  double last = kMissing;
  for (const auto& [n, log_miss] : line.medians) {
    if (std::isfinite(log_miss)) last = log_miss + line.shift;
  }
  return {kRight + 5, frame.y.pixel(last) + 4, real.settings[line.setting].name,
          fill_class(line.setting)};
}

/// kappa C over n, from its 10 % to its 90 % quantile, in units of 2^-p radians.
std::string band_svg(const MissModel& model, const std::string& family, const PlotFrame& frame,
                     NamedPlot& plot) {
  const auto at = model.log_condition.find(family);
  if (model.drawings == 0 || at == model.log_condition.end()) return "";
  std::string lower, upper;
  for (const auto& [n, log_c] : at->second) {
    const double x = log10_of(n);
    upper += frame.point(x, model.log_kappa[2] + log_c);
    lower.insert(0, frame.point(x, model.log_kappa[0] + log_c));
    plot.csv += csv_line("predicted", "band", x, model.log_kappa[1] + log_c,
                         model.log_kappa[0] + log_c, model.log_kappa[2] + log_c);
  }
  return "<polygon class='band f0' points='" + upper + lower + "'/>";
}

std::vector<MissLine> lines_of(const RealRows& real, const std::string& family, bool in_roundings) {
  std::vector<MissLine> lines;
  for (std::size_t setting = 0; setting < real.settings.size(); ++setting) {
    const int bits = real.settings[setting].bits;
    if (in_roundings && bits == 0) continue;
    MissLine line{setting, median_misses(real, setting, family), 0};
    if (in_roundings) line.shift = bits * std::log10(2.0) - std::log10(57.29577951308232);
    const bool has_any = std::any_of(line.medians.begin(), line.medians.end(),
                                     [](const auto& one) { return std::isfinite(one.second); });
    if (has_any) lines.push_back(std::move(line));
  }
  return lines;
}

NamedPlot miss_plot(Page& page, const GraphsByRow& graphs, const RealRows& real,
                    const MissModel& model, bool in_roundings) {
  const std::string family = sample_family(real);
  NamedPlot plot;
  plot.file = in_roundings ? "miss-in-roundings" : "miss";
  plot.title = in_roundings ? "The same in units of each type's rounding"
                            : "Largest miss of an angle against n";
  plot.note =
      in_roundings
          ? fmt::format(
                "{}: miss in radians · 2^p, p bits; shaded: κC from the drawings in {} alone",
                family, real.settings[model.setting].name)
          : family + ": medians, and one point per drawing";
  plot.x = "vertices n";
  plot.y = in_roundings ? "miss in roundings of the type" : "largest miss in degrees";
  const std::vector<MissLine> lines = lines_of(real, family, in_roundings);
  LogRange x, y;
  for (const RealRow& row : real.rows) {
    if (row.family != family || !std::isfinite(row.log_miss)) continue;
    x.include(log10_of(row.n));
    for (const MissLine& line : lines) {
      if (line.setting == row.setting) y.include(row.log_miss + line.shift);
    }
  }
  if (x.empty() || y.empty()) return plot;
  const PlotFrame frame = frame_of(x, y, TickStyle::power, plot.y);
  std::string svg = axes_svg(frame);
  if (in_roundings) svg += band_svg(model, family, frame, plot);
  std::vector<Label> labels;
  for (const MissLine& line : lines) {
    svg += points_svg(page, graphs, real, family, line, frame, plot) +
           median_svg(real, line, frame, plot);
    labels.push_back(label_of(real, line, frame));
  }
  plot.svg = labelled_svg(plot.title, svg, std::move(labels));
  return plot;
}

/// The graphs of one family at its largest n.
struct LargestOf {
  std::int64_t n = -1;
  std::map<std::size_t, std::vector<double>> misses;  ///< log10, by setting
  std::vector<double> conditions;
};

std::string miss_cell(const LargestOf& of, std::size_t setting) {
  const auto at = of.misses.find(setting);
  if (at == of.misses.end()) return cell("–", true);
  const double largest = *std::max_element(at->second.begin(), at->second.end());
  return cell(std::isfinite(largest) ? fmt::format("{:.2g}", std::pow(10, largest)) : "0", true);
}

}  // namespace

std::string miss_figures(Page& page, const RealRows& real, const MissModel& model) {
  std::string html;
  const GraphsByRow graphs = graphs_by_row(page.analysis.tally);
  for (const bool in_roundings : {false, true}) {
    if (in_roundings && model.drawings == 0) continue;
    NamedPlot plot = miss_plot(page, graphs, real, model, in_roundings);
    if (!plot.svg.empty()) html += page.figure(std::move(plot));
  }
  return html;
}

std::string miss_table(const RealRows& real, const MissModel& model) {
  std::map<std::string, LargestOf> families;
  for (const RealRow& row : real.rows) {
    LargestOf& of = families[row.family];
    if (row.requested_n < of.n) continue;
    if (row.requested_n > of.n) of = {row.requested_n, {}, {}};
    of.misses[row.setting].push_back(row.log_miss);
    if (row.setting == model.setting) of.conditions.push_back(row.log_condition);
  }
  std::vector<std::string> columns = {"Family", "#n"};
  for (const RealSetting& setting : real.settings) columns.push_back("#" + escape(setting.name));
  columns.push_back("#log2 C");
  std::string html =
      "<details open><summary>Families</summary><p class=muted>Largest miss in degrees over the "
      "graphs of the largest n, by type; C is the median condition, log2 of which is the number of "
      "bits that angles lose.</p>" +
      table_head(columns);
  for (const auto& [family, of] : families) {
    html += row_head(family) + cell(grouped(of.n), true);
    for (std::size_t i = 0; i < real.settings.size(); ++i) html += miss_cell(of, i);
    const double log_c = median(of.conditions);
    html +=
        cell(std::isfinite(log_c) ? fmt::format("{:.1f}", log_c / std::log10(2.0)) : "–", true) +
        "</tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

std::string share_table(const RealRows& real) {
  struct Shares {
    std::size_t drawings = 0;
    std::array<double, 4> sum{};
    std::array<std::size_t, 4> whole{};
    std::size_t broken = 0;
  };
  std::map<std::pair<std::int64_t, std::size_t>, Shares> all;  // by n and setting
  for (const RealRow& row : real.rows) {
    Shares& shares = all[{row.requested_n, row.setting}];
    ++shares.drawings;
    shares.broken += row.is_broken;
    for (std::size_t i = 0; i < 4; ++i) {
      shares.sum[i] += std::isnan(row.within[i]) ? 1 : row.within[i];  // no angles: none misses
      shares.whole[i] += row.within[i] == 1 || std::isnan(row.within[i]);
    }
  }
  std::string html =
      "<details open><summary>Shares</summary><p class=muted>Mean share of a drawing's angles that "
      "miss by at most so many degrees, and (grey) share of drawings all of whose angles do, over "
      "all families. Broken: drawings with a crossing or a segment of length zero.</p>" +
      table_head({"Type", "#n", "#Drawings", "#10⁻¹²", "#10⁻⁹", "#10⁻⁶", "#10⁻³", "#Broken"});
  for (const auto& [key, shares] : all) {
    const auto count = static_cast<double>(shares.drawings);
    html += row_head(real.settings[key.second].name) + cell(grouped(key.first), true) +
            cell(fmt::format("{}", shares.drawings), true);
    for (std::size_t i = 0; i < 4; ++i) {
      html += cell(fmt::format("{} <small>· {}</small>", percent(shares.sum[i] / count),
                               percent(static_cast<double>(shares.whole[i]) / count)),
                   true);
    }
    html += cell(fmt::format("{}", shares.broken), true) + "</tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

}  // namespace ar3d::report
