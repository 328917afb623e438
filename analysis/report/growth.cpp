// Growth as compensated plots: a quantity divided by the order of the theorem's bound, so
// that a constant is a horizontal line and a wrong exponent is visible.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kEndsNamed = 2;   // families with the largest values, and with the least
constexpr std::size_t kAllNamed = 6;    // so few families are all drawn and named
constexpr double kFarBound = 1.5;       // decades: a bound further up is told, not drawn
constexpr double kPointBudget = 60000;  // points of a page
constexpr std::size_t kMostBinsOfALine = 16;
constexpr double kLineBudget = 200000;  // sizes of a page's lines

/// One family: decimal logarithms, divided by the order.
struct FamilyLine {
  const SectionCurve* curve = nullptr;
  const ScalingEntry* entry = nullptr;
  std::size_t index = 0;  // in the section
  std::vector<SizeSample> sizes;
};

struct GrowthFigure {
  Quantity quantity;
  double order = 1;
  std::vector<FamilyLine> lines;
  std::size_t points_of_a_size = 12, sizes_of_a_line = 200;

  double value(const SizeSample& size, double log) const {
    return decimal(log) - order * log10_of(size.n);
  }
  double middle(const SizeSample& size) const { return value(size, median(size.log_values())); }
};

// The power of n that a figure divides by: without a theorem that of the box of a line of vertices.
double order_of(const Section& section, Quantity quantity) {
  if (quantity == Quantity::wall_s) return 1;
  const double without = quantity == Quantity::volume ? 3 : 1;
  return section.theorem ? theorem_order(*section.theorem, quantity).value_or(without) : without;
}

std::string power_text(double order) {
  return order == 1 ? "n" : order == 0.5 ? "√n" : fmt::format("n^{:.3g}", order);
}

/// The sizes of a collection in bins on a logarithmic scale: values are moved along n^order to the
/// middle of their bin, so that a figure that divides by it shows what it showed.
std::vector<SizeSample> binned(const std::vector<SizeSample>& all, double order) {
  std::set<std::int64_t> sizes;
  for (const SizeSample& size : all) sizes.insert(size.n);
  std::vector<SizeSample> samples;
  auto next = all.begin();
  for (const SizeBin& bin : size_bins(sizes, kMostBinsOfALine)) {
    SizeSample& sample = samples.emplace_back();
    sample.n = sample.requested_n =
        std::llround(std::sqrt(static_cast<double>(bin.first) * static_cast<double>(bin.last)));
    const auto log = [](std::int64_t n) { return std::log(static_cast<double>(n)); };
    for (; next != all.end() && next->n <= bin.last; ++next) {
      const double moved = order * (log(sample.n) - log(next->n));
      if (std::isnan(sample.log_bound)) sample.log_bound = next->log_bound + moved;
      for (const InstanceValue& value : next->instances) {
        sample.instances.push_back({value.log_value + moved, value.row});
      }
    }
  }
  return samples;
}

/// The families' medians by requested n.
std::map<std::int64_t, std::vector<double>> band_of(const GrowthFigure& growth) {
  std::map<std::int64_t, std::vector<double>> band;
  for (const FamilyLine& line : growth.lines) {
    for (const SizeSample& size : line.sizes) {
      band[size.requested_n].push_back(growth.middle(size));
    }
  }
  return band;
}

/// The theorem's bound by n, divided by the order.
std::map<std::int64_t, double> bound_of(const GrowthFigure& growth) {
  std::map<std::int64_t, double> bound;
  for (const FamilyLine& line : growth.lines) {
    for (const SizeSample& size : line.sizes) {
      if (!std::isnan(size.log_bound)) bound[size.n] = growth.value(size, size.log_bound);
    }
  }
  return bound;
}

LogRange data_range(const GrowthFigure& growth, LogRange& x) {
  LogRange y;
  for (const FamilyLine& line : growth.lines) {
    for (const SizeSample& size : line.sizes) {
      x.include(log10_of(size.n));
      for (const InstanceValue& one : size.instances) y.include(growth.value(size, one.log_value));
    }
    for (const CensoredRow& row : line.entry->censored) x.include(log10_of(row.n));
  }
  return y;
}

/// The families with the largest and the least values at the largest sizes; all if they are few.
std::vector<std::size_t> extreme_lines(const GrowthFigure& growth) {
  std::vector<std::size_t> order, to_the_end;  // of the sizes
  std::int64_t largest = 0;
  for (const FamilyLine& line : growth.lines) {
    largest = std::max(largest, line.sizes.back().requested_n);
  }
  for (std::size_t i = 0; i < growth.lines.size(); ++i) {
    order.push_back(i);
    if (growth.lines[i].sizes.back().requested_n == largest) to_the_end.push_back(i);
  }
  if (order.size() <= kAllNamed) return order;
  if (to_the_end.size() >= 2 * kEndsNamed) order = std::move(to_the_end);
  const auto last = [&](std::size_t i) { return growth.middle(growth.lines[i].sizes.back()); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return last(a) > last(b); });
  std::vector<std::size_t> extremes(order.begin(), order.begin() + kEndsNamed);
  extremes.insert(extremes.end(), order.end() - kEndsNamed, order.end());
  return extremes;
}

std::string band_svg(const GrowthFigure& growth, const PlotFrame& frame, std::string& csv) {
  std::string upper, lower, middle;
  for (const auto& [n, values] : band_of(growth)) {
    const double x = log10_of(std::max<std::int64_t>(1, n)), centre = median(values);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    upper += frame.point(x, *most);
    lower.insert(0, frame.point(x, *least));
    middle += frame.point(x, centre);
    csv += csv_line("all families", "band", x, centre, *least, *most);
  }
  return fmt::format(
      "<polygon class='band f0' points='{}{}'/><polyline class='median middle' points='{}'/>",
      upper, lower, middle);
}

/// The bound as a dashed line, unless it lies far above all data.
std::string bound_svg(const std::map<std::int64_t, double>& bound, const PlotFrame& frame,
                      bool is_far, std::string& csv) {
  std::string points;
  const std::size_t step = std::max<std::size_t>(1, bound.size() / 60);
  std::size_t i = 0;
  for (const auto& [n, value] : bound) {
    const bool is_end = i == 0 || i + 1 == bound.size();
    if (i++ % step != 0 && !is_end) continue;
    points += frame.point(log10_of(n), value);
    csv += csv_line("theorem's bound", "dashed", log10_of(n), value);
  }
  return points.empty() || is_far ? "" : "<polyline class='bound' points='" + points + "'/>";
}

std::string line_svg(Page& page, const GrowthFigure& growth, const FamilyLine& line,
                     const PlotFrame& frame, bool is_extreme, std::size_t colour,
                     std::string& csv) {
  std::string points;
  Dots dots, cut_off;
  std::map<std::size_t, const DrawnGraph*> graph_of;
  for (const auto& [n, size] : line.curve->tally->sizes) {
    for (const DrawnGraph& graph : size.graphs) graph_of[graph.row] = &graph;
  }
  std::vector<const SizeSample*> sizes;
  for (const SizeSample& size : line.sizes) sizes.push_back(&size);
  for (const SizeSample* size : evenly(sizes, growth.sizes_of_a_line)) {
    const std::vector<double> values = size->log_values();
    const double x = log10_of(size->n), y = growth.middle(*size);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    points += frame.point(x, y);
    csv += csv_line(line.curve->family, "line", x, y, growth.value(*size, *least),
                    growth.value(*size, *most));
    for (const InstanceValue& one : shown_points(*size, growth.points_of_a_size)) {
      dots.add(frame.x.pixel(x), frame.y.pixel(growth.value(*size, one.log_value)),
               page.point_at(line.curve->place, *graph_of.at(one.row)));
    }
  }
  for (const CensoredRow& row : line.entry->censored) {
    cut_off.add(frame.x.pixel(log10_of(row.n)), kTop + 4, page.point_at(line.curve->place, row));
  }
  return fmt::format(
      "<g class='family{}' data-f='{}'><polyline class='median {}' "
      "points='{}'><title>{}</title></polyline>{}{}</g>",
      is_extreme ? " extreme" : "", line.index, stroke_class(colour), points,
      escape(line.curve->family), dots.svg("points " + stroke_class(colour)),
      cut_off.svg("points cut"));
}

GrowthFigure growth_of(Page& page, const Section& section, Quantity quantity) {
  GrowthFigure growth{quantity, order_of(section, quantity), {}};
  for (std::size_t i = 0; i < section.shown.size(); ++i) {
    const SectionCurve& curve = section.shown[i];
    const ScalingEntry* entry = curve.scaling[static_cast<std::size_t>(quantity)];
    if (entry == nullptr) continue;
    growth.lines.push_back(
        {&curve, entry, i, curve.is_collection ? binned(entry->all, growth.order) : entry->all});
  }
  std::size_t sizes = 0;
  for (const CurveTally& curve : page.analysis.tally.curves) sizes += curve.sizes.size();
  const double count = 3 * static_cast<double>(std::max<std::size_t>(1, sizes));
  growth.points_of_a_size = static_cast<std::size_t>(std::clamp(kPointBudget / count, 0.0, 12.0));
  growth.sizes_of_a_line = static_cast<std::size_t>(std::clamp(
      kLineBudget / 3 / static_cast<double>(page.analysis.tally.curves.size()), 12.0, 200.0));
  return growth;
}

std::string unit_text(const Section& section, Quantity quantity) {
  if (quantity == Quantity::volume && section.has_own_unit) return "vertex distances³";
  return quantity == Quantity::wall_s ? "s" : unit_of(quantity);
}

NamedPlot growth_plot(Page& page, const Section& section, const GrowthFigure& growth) {
  std::string name = name_of(growth.quantity);
  NamedPlot plot;
  plot.title = section.label + ": " + name;
  plot.file = section.label + "-" + name;
  plot.x = "vertices n";
  plot.y = name + " / " + power_text(growth.order);
  LogRange x, y = data_range(growth, x);
  const double top = y.high;
  const std::map<std::int64_t, double> bound = bound_of(growth);
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [n, value] : bound) nearest = std::min(nearest, value);
  const bool is_far = !bound.empty() && nearest > top + kFarBound;
  if (!is_far) {
    for (const auto& [n, value] : bound) y.include(value);
  }
  const bool is_time = growth.quantity == Quantity::wall_s;
  const bool is_wide = growth.quantity == Quantity::volume || y.low < -2;
  const TickStyle ticks = is_time   ? TickStyle::seconds
                          : is_wide ? TickStyle::power
                                    : TickStyle::count;
  const PlotFrame frame =
      frame_of(x, y, ticks, plot.y + ", " + unit_text(section, growth.quantity));
  std::string svg = axes_svg(frame);
  svg += band_svg(growth, frame, plot.csv);
  svg += bound_svg(bound, frame, is_far, plot.csv);
  const std::vector<std::size_t> extremes = extreme_lines(growth);
  std::vector<Label> labels;
  for (std::size_t i = 0; i < growth.lines.size(); ++i) {
    const auto at = std::find(extremes.begin(), extremes.end(), i);
    const bool is_extreme = at != extremes.end();
    const std::size_t colour = is_extreme ? static_cast<std::size_t>(at - extremes.begin()) + 1 : 7;
    const FamilyLine& line = growth.lines[i];
    svg += line_svg(page, growth, line, frame, is_extreme, colour, plot.csv);
    if (!is_extreme) continue;
    labels.push_back({kRight + 5, frame.y.pixel(growth.middle(line.sizes.back())) + 4,
                      line.curve->name, fill_class(colour)});
  }
  if (!bound.empty() && !is_far) {
    labels.push_back(
        {kRight + 5, frame.y.pixel(bound.rbegin()->second) + 4, "theorem's bound", "of-bound"});
  }
  plot.svg = labelled_svg(
      plot.title + ", divided by " + power_text(growth.order) + ", against n by family", svg,
      std::move(labels));
  std::set<std::string> families;
  for (const FamilyLine& line : growth.lines) families.insert(line.curve->family);
  plot.note = fmt::format("{} families", count_families(families));
  if (is_far) {
    plot.note += fmt::format("; the theorem's bound lies at least {:.3g} times above",
                             std::pow(10, nearest - top));
  }
  return plot;
}

/// By requested n the volumes that any drawing needs, those drawn and those promised.
struct VolumeBand {
  std::vector<double> least, drawn, most;
};

std::map<std::int64_t, VolumeBand> volume_bands(const GrowthFigure& growth) {
  std::map<std::int64_t, VolumeBand> bands;
  for (const FamilyLine& line : growth.lines) {
    for (const SizeSample& size : line.entry->all) {
      VolumeBand& band = bands[size.requested_n];
      band.drawn.push_back(growth.middle(size));
      if (!std::isnan(size.log_bound)) band.most.push_back(growth.value(size, size.log_bound));
      for (const DrawnGraph& graph : line.curve->tally->sizes.at(size.n).graphs) {
        const double least = log_volume_at_least(graph);
        if (!std::isnan(least)) band.least.push_back(growth.value(size, least));
      }
    }
  }
  std::erase_if(bands, [](const auto& band) {
    return band.second.least.empty() || band.second.most.empty();
  });
  return bands;
}

/// One band: below it nothing can be, above it the theorem promises that nothing is; the drawings
/// lie in between. Empty without bounds from both sides.
std::string volume_band_figure(Page& page, const Section& section) {
  const GrowthFigure growth = growth_of(page, section, Quantity::volume);
  const std::map<std::int64_t, VolumeBand> bands = volume_bands(growth);
  if (bands.empty()) return "";
  NamedPlot plot;
  plot.file = section.label + "-volume-band";
  plot.title = section.label + ": volume between its bounds";
  plot.x = "vertices n";
  plot.y = "volume / " + power_text(growth.order);
  LogRange x, y;
  std::string points, drawn, most;
  for (const auto& [n, band] : bands) {
    x.include(log10_of(std::max<std::int64_t>(1, n)));
    y.include(std::ranges::min(band.least));
    y.include(std::ranges::max(band.most));
  }
  const PlotFrame frame =
      frame_of(x, y, TickStyle::power, plot.y + ", " + unit_text(section, Quantity::volume));
  for (const auto& [n, band] : bands) {
    const double at = log10_of(std::max<std::int64_t>(1, n)), middle = median(band.drawn);
    const double low = std::ranges::min(band.least), high = std::ranges::max(band.most);
    points += frame.point(at, low);
    most.insert(0, frame.point(at, high));
    drawn += frame.point(at, middle);
    plot.csv += csv_line("drawn, from at least to at most", "band", at, middle, low, high);
  }
  plot.svg = labelled_svg(
      plot.title + ", against n",
      axes_svg(frame) + fmt::format("<polygon class='band f0' points='{}{}'/><polyline "
                                    "class='median middle' points='{}'/>",
                                    points, most, drawn),
      {});
  plot.note = "below: proved impossible; above: excluded by the theorem; line: drawn, median";
  return page.figure(std::move(plot));
}

}  // namespace

std::string growth_figures(Page& page, const Section& section) {
  std::string html;
  for (const Quantity quantity : {Quantity::longest_side, Quantity::volume, Quantity::wall_s}) {
    const GrowthFigure growth = growth_of(page, section, quantity);
    if (!growth.lines.empty()) html += page.figure(growth_plot(page, section, growth));
  }
  html += volume_band_figure(page, section);
  if (html.empty()) return "";
  return "<div class=figures>\n" + html +
         "</div>\n<p class='muted legend-line'>Band and thick line: least, median and largest of "
         "the families' medians. Lines: families, named at their end. Dashed: the theorem's "
         "bound.</p>\n";
}

}  // namespace ar3d::report
