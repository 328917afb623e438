// How quantities grow, as figures show it: every value is divided by n to the order of the
// theorem's bound, so that a constant is a horizontal line and a wrong exponent is visible.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/scaling/scaling.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr double kFarBound = 1.5;       // decades: a bound further up is named, not drawn
constexpr double kPointBudget = 60000;  // points of a page
constexpr double kLineBudget = 66000;   // sizes of a page's lines
constexpr std::size_t kMostBinsOfALine = 16;

double log_n(std::int64_t n) { return std::log(static_cast<double>(n)); }

/// The sizes of a collection in bins on a logarithmic scale: values are moved along n^order to one n
/// of their bin, so that a figure that divides by it shows what it showed.
std::vector<SizeSample> binned(const std::vector<SizeSample>& all, double order) {
  std::set<std::int64_t> sizes;
  for (const SizeSample& size : all) sizes.insert(size.n);
  std::vector<SizeSample> samples;
  auto next = all.begin();
  for (const auto& [first, last, n] : size_bins(sizes, kMostBinsOfALine)) {
    SizeSample& sample = samples.emplace_back();
    sample.n = n;
    for (; next != all.end() && next->n <= last; ++next) {
      const double moved = order * (log_n(sample.n) - log_n(next->n));
      if (std::isnan(sample.log_bound)) sample.log_bound = next->log_bound + moved;
      for (const auto& [log, row] : next->instances) {
        sample.instances.emplace_back(log + moved, row);
      }
    }
  }
  return samples;
}

/// One setting in one quantity: what a figure shows.
struct Figure {
  std::size_t setting = 0;
  Quantity quantity{};
  double order = 1;
  std::vector<std::pair<const SectionCurve*, std::vector<SizeSample>>> lines = {};

  double over(const SizeSample& size, double log) const {
    return std::exp(log - order * log_n(size.n));
  }
  double middle(const SizeSample& size) const { return over(size, median(size.log_values())); }
};

Figure figure_of(const TableMaker& make, std::size_t setting, Quantity quantity) {
  const Section& section = make.sections[setting];
  Figure figure{setting, quantity, order_of(section, quantity)};
  for (const SectionCurve& curve : make.all ? section.curves : section.shown) {
    const ScalingEntry* entry = curve.growth(quantity);
    if (entry == nullptr || entry->reason == kUntimed) continue;
    figure.lines.emplace_back(&curve,
                              curve.is_collection ? binned(entry->all, figure.order) : entry->all);
  }
  return figure;
}

void add_lines(const Figure& figure, std::size_t most_sizes, Table& table) {
  for (const auto& [curve, sizes] : figure.lines) {
    for (const SizeSample& size : evenly(sizes, most_sizes)) {
      const auto [least, largest] = std::ranges::minmax_element(
          size.instances, {}, [](const auto& graph) { return graph.first; });
      table.add({curve->index, name_of(figure.quantity), size.n, size.instances.size(),
                 figure.over(size, least->first), figure.middle(size),
                 figure.over(size, largest->first), largest->second,
                 figure.over(size, size.log_bound), std::exp(figure.order * log_n(size.n))});
    }
  }
}

/// The families' medians by bins of n.
void add_band_of(const Figure& figure, TableMaker& make) {
  std::map<std::int64_t, std::map<std::size_t, std::vector<double>>> band;
  for (const auto& [curve, sizes] : figure.lines) {
    for (const SizeSample& size : sizes) {
      band[bin_of(make.bins, size.n).n][curve->index].push_back(figure.middle(size));
    }
  }
  add_band(make, figure.setting, name_of(figure.quantity), band);
}

/// The theorem's bound by n, and how far above all data it lies.
void add_bound(const Figure& figure, const Section& section, Table& bounds, Table& figures) {
  std::map<std::int64_t, double> bound;
  double nearest = std::numeric_limits<double>::infinity(), top = 0;
  std::set<std::string> families;
  for (const auto& [curve, sizes] : figure.lines) {
    families.insert(curve->family);
    for (const SizeSample& size : sizes) {
      if (!std::isnan(size.log_bound)) bound[size.n] = figure.over(size, size.log_bound);
      top = std::max(top, figure.over(size, std::ranges::max(size.log_values())));
    }
  }
  for (const auto& [n, value] : bound) nearest = std::min(nearest, value);
  const bool is_far = std::log10(nearest / top) > kFarBound;  // also without a bound
  figures.add({figure.setting, name_of(figure.quantity), unit_of(section, figure.quantity),
               figure.order, count_families(families), is_far ? nearest / top : kMissing});
  const std::vector<std::pair<std::int64_t, double>> all(bound.begin(), bound.end());
  for (const auto& [n, value] : evenly(all, 60)) {
    bounds.add({figure.setting, name_of(figure.quantity), n, value});
  }
}

/// Points of the figures: graphs of every size, evenly over their sides, and those that take most
/// volume and time.
void add_points(TableMaker& make, std::size_t most) {
  for (const Section& section : make.sections) {
    for (const SectionCurve& curve : section.shown) {
      const bool timed = curve.tally->has_timing_rows;
      for (const auto& [n, size] : curve.tally->sizes) {
        if (n < 1 || size.graphs.empty() || most == 0) continue;
        std::vector<const DrawnGraph*> graphs;
        for (const DrawnGraph& graph : size.graphs) graphs.push_back(&graph);
        const auto side = [&](const DrawnGraph* graph) {
          return log_value(*graph, Quantity::longest_side, timed);
        };
        std::erase_if(graphs, [&](const DrawnGraph* graph) {
          return std::isnan(side(graph)) && std::isnan(graph->log2_volume);
        });
        if (graphs.empty()) continue;
        std::ranges::stable_sort(graphs, {}, side);
        for (const DrawnGraph* graph : evenly(graphs, most))
          make.add_graph(curve.index, *graph, true);
        for (const Quantity quantity : {Quantity::volume, Quantity::wall_s}) {
          if (quantity == Quantity::wall_s && !timed) continue;
          const DrawnGraph* largest =
              *std::ranges::max_element(graphs, {}, [&](const DrawnGraph* graph) {
                const double log = log_value(*graph, quantity, timed);
                return std::isnan(log) ? -std::numeric_limits<double>::infinity() : log;
              });
          make.add_graph(curve.index, *largest, true);
        }
      }
      for (const DrawnGraph& row : curve.tally->censored) make.add_graph(curve.index, row, true);
    }
  }
}

/// One band: below it nothing can be, above it the theorem promises that nothing is; the drawings
/// lie in between.
void add_volume_bands(TableMaker& make) {
  Table& table = make.table("volume_bands");
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    const Figure figure = figure_of(make, i, Quantity::volume);
    std::map<std::int64_t, std::array<std::vector<double>, 3>> bands;
    for (const auto& [curve, sizes] : figure.lines) {
      for (const SizeSample& size : curve->growth(Quantity::volume)->all) {
        auto& [least, drawn, most] = bands[bin_of(make.bins, size.n).n];
        drawn.push_back(figure.middle(size));
        if (!std::isnan(size.log_bound)) most.push_back(figure.over(size, size.log_bound));
        for (const DrawnGraph& graph : curve->tally->sizes.at(size.n).graphs) {
          const double log = log_volume_at_least(graph);
          if (!std::isnan(log)) least.push_back(figure.over(size, log));
        }
      }
    }
    for (const auto& [n, band] : bands) {
      const auto& [least, drawn, most] = band;
      if (least.empty() || most.empty()) continue;
      table.add({i, n, std::ranges::min(least), median(drawn), std::ranges::max(most)});
    }
  }
}

}  // namespace

void add_band(TableMaker& make, std::size_t setting, const char* quantity,
              const std::map<std::int64_t, std::map<std::size_t, std::vector<double>>>& values) {
  for (const auto& [n, curves] : values) {
    const SizeBin& bin = bin_of(make.bins, n);
    std::vector<double> medians;
    for (const auto& [curve, of_curve] : curves) medians.push_back(median(of_curve));
    const auto [least, largest] = std::ranges::minmax(medians);
    make.table("bands").add({setting, quantity, bin.n, medians.size(), least, median(medians),
                             largest, bin.first, bin.last});
  }
}

void add_curves(TableMaker& make) {
  // How much a page may hold: points of a size, and sizes of a line.
  const std::vector<CurveTally>& tallies = make.analysis.tally.curves;
  double sizes = 1;
  for (const CurveTally& curve : tallies) sizes += static_cast<double>(curve.sizes.size());
  const auto most_points =
      static_cast<std::size_t>(std::clamp(kPointBudget / (3 * sizes), 0.0, 12.0));
  const double share = kLineBudget / std::max(1.0, static_cast<double>(tallies.size()));
  const auto most_sizes = static_cast<std::size_t>(std::clamp(share, 12.0, 200.0));
  Table& curves = make.table("curves");
  Table& bounds = make.table("bound_lines");
  Table& figures = make.table("figures");
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    std::vector<Quantity> shown = {nearest_side(make.sections[i]), Quantity::volume,
                                   Quantity::wall_s};
    if (make.all) shown.assign(kQuantities.begin(), kQuantities.end());
    for (const Quantity quantity : shown) {
      const Figure figure = figure_of(make, i, quantity);
      if (figure.lines.empty()) continue;
      add_lines(figure, make.all ? figure.lines.size() + 100000 : most_sizes, curves);
      add_band_of(figure, make);
      add_bound(figure, make.sections[i], bounds, figures);
    }
  }
  add_points(make, most_points);
  add_volume_bands(make);
}

}  // namespace ar3d::report
