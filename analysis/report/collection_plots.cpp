// Figures of a collection: performance profiles, scatters of one setting against another, medians
// over bins of n.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ar3d/analysis/report/collection.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kScatterPoints = 1000;  // of a scatter
constexpr std::size_t kOutliers = 3;          // on either side
constexpr std::size_t kMostBins = 16;
constexpr double kProfileEnd = 4;  // decades behind the best

std::string graph_name(const DrawnGraph& graph) {
  return graph.name.empty() ? fmt::format("graph {}", graph.instance) : graph.name;
}

/// For each setting the sorted decades by which it is behind the best one, by graph.
std::vector<std::vector<double>> behind_best(const Collection& collection,
                                             const CollectionMeasure& measure,
                                             std::size_t& graphs) {
  std::vector<std::vector<double>> behind(collection.settings.size());
  for (const auto& [key, one] : collection.graphs) {
    double best = kMissing;
    std::vector<std::pair<std::size_t, double>> costs;
    for (const auto& [setting, graph] : one.drawn) {
      const double value = measure.log10_value(collection, *graph);
      if (std::isnan(value)) continue;
      costs.emplace_back(setting, measure.is_larger_better ? -value : value);
      best = std::fmin(best, costs.back().second);
    }
    graphs += !costs.empty();
    for (const auto& [setting, cost] : costs) behind[setting].push_back(cost - best);
  }
  for (std::vector<double>& decades : behind) std::ranges::sort(decades);
  return behind;
}

std::string outlier_list(Page& page, const Collection& collection, std::size_t a, std::size_t b,
                         const std::vector<CollectionPair>& ends) {
  std::string html = "<ul class=crossings>";
  for (const CollectionPair& pair : ends) {
    const auto button = [&](std::size_t setting, const DrawnGraph& graph) {
      const CollectionSetting& one = collection.settings[setting];
      return graph_button(page, one.curve->place, graph, escape(one.label));
    };
    html += fmt::format("<li>{}, n = {}: × {} {} {}</li>", escape(graph_name(*pair.one)),
                        grouped(pair.one->n), number_text(pair.ratio()), button(a, *pair.one),
                        button(b, *pair.other));
  }
  return html + "</ul>";
}

}  // namespace

NamedPlot profile_plot(const Collection& collection, const CollectionMeasure& measure) {
  NamedPlot plot{collection.family + "-profile-" + measure.name,
                 std::string("Within a factor of the best: ") + measure.title, ""};
  std::size_t graphs = 0;
  const auto behind = behind_best(collection, measure, graphs);
  double end = 0.1;
  for (const auto& decades : behind) {
    if (!decades.empty()) end = std::max(end, std::min(kProfileEnd, decades.back()));
  }
  if (graphs == 0) return plot;
  plot.note = fmt::format("share of {} graphs that some setting drew",
                          grouped(static_cast<std::int64_t>(graphs)));
  plot.x = "factor";
  plot.y = "share of graphs";
  plot.has_linear_y = true;
  const PlotFrame frame{LogAxis(0, end, kLeft, kRight),
                        LogAxis(0, 1, kBottom, kTop + 16),
                        end < 3 ? TickStyle::count : TickStyle::power,
                        TickStyle::share,
                        "factor of the best",
                        plot.y};
  std::string svg = axes_svg(frame);
  std::vector<Label> labels;
  constexpr int kSteps = 80;
  for (std::size_t s = 0; s < behind.size(); ++s) {
    if (behind[s].empty()) continue;
    std::string points;
    double share = 0;
    for (int step = 0; step <= kSteps; ++step) {
      const double x = end * step / kSteps;
      const auto within = std::ranges::upper_bound(behind[s], x + 1e-9) - behind[s].begin();
      share = static_cast<double>(within) / static_cast<double>(graphs);
      points += frame.point(x, share);
      plot.csv += csv_line(collection.settings[s].label, "line", x, std::log10(share));
    }
    svg += fmt::format("<polyline class='median {}' points='{}'/>", stroke_class(s), points);
    labels.push_back(
        {kRight + 5, frame.y.pixel(share) + 4, collection.settings[s].label, fill_class(s)});
  }
  plot.svg = labelled_svg(plot.title, svg, std::move(labels));
  return plot;
}

std::vector<CollectionPair> pairs_of(const Collection& collection, const CollectionMeasure& measure,
                                     std::size_t a, std::size_t b) {
  std::vector<CollectionPair> pairs;
  for (const auto& [key, one] : collection.graphs) {
    const DrawnGraph *by_a = drawn_by(one, a), *by_b = drawn_by(one, b);
    if (by_a == nullptr || by_b == nullptr) continue;
    const CollectionPair pair{by_a, by_b, measure.log10_value(collection, *by_a),
                              measure.log10_value(collection, *by_b)};
    if (!std::isnan(pair.ratio())) pairs.push_back(pair);
  }
  std::ranges::stable_sort(pairs, {}, &CollectionPair::ratio);
  return pairs;
}

std::vector<CollectionPair> outliers(const std::vector<CollectionPair>& pairs) {
  if (pairs.size() <= 2 * kOutliers) return pairs;
  std::vector<CollectionPair> ends(pairs.begin(), pairs.begin() + kOutliers);
  ends.insert(ends.end(), pairs.end() - kOutliers, pairs.end());
  return ends;
}

NamedPlot scatter_plot(Page& page, const Collection& collection, const CollectionMeasure& measure,
                       std::size_t a, std::size_t b) {
  const std::string &label = collection.settings[a].label, &other = collection.settings[b].label;
  const std::vector<CollectionPair> pairs = pairs_of(collection, measure, a, b);
  NamedPlot plot{fmt::format("{}-{}-{}-{}", collection.family, measure.name, a, b),
                 fmt::format("{}: {} against {}", measure.title, other, label), ""};
  if (pairs.empty()) return plot;
  std::size_t above = 0;
  LogRange range;
  for (const CollectionPair& pair : pairs) {
    above += pair.ratio() > 0;
    range.include(pair.x);
    range.include(pair.y);
  }
  plot.note = fmt::format("{} graphs that both drew; above the diagonal {}",
                          grouped(static_cast<std::int64_t>(pairs.size())),
                          percent(static_cast<double>(above) / static_cast<double>(pairs.size())));
  plot.x = label;
  plot.y = other;
  PlotFrame frame = frame_of(range, range, measure.ticks, other);
  frame.x_ticks = measure.ticks;
  frame.x_title = label;
  std::string svg = axes_svg(frame) + fmt::format("<polyline class='bound' points='{}{}'/>",
                                                  frame.point(range.low, range.low),
                                                  frame.point(range.high, range.high));
  Dots dots;
  for (const CollectionPair& pair : evenly(pairs, kScatterPoints)) {
    dots.add(frame.x.pixel(pair.x), frame.y.pixel(pair.y),
             page.point_at(collection.settings[b].curve->place, *pair.other));
    plot.csv += csv_line("graphs", "point", pair.x, pair.y);
  }
  svg += dots.svg("points " + stroke_class(0));
  std::vector<Label> labels;
  const std::vector<CollectionPair> ends = outliers(pairs);
  for (const CollectionPair& pair : ends) {
    const double x = frame.x.pixel(pair.x), y = frame.y.pixel(pair.y);
    svg += fmt::format("<circle class='crossing' cx='{:.1f}' cy='{:.1f}' r='4'/>", x, y);
    labels.push_back({x + 7, y + 4, graph_name(*pair.one), fill_class(1)});
  }
  plot.svg = labelled_svg(plot.title, svg, std::move(labels), kTop + 26);
  plot.legend = outlier_list(page, collection, a, b, ends);
  return plot;
}

NamedPlot sizes_plot(const Collection& collection, const CollectionMeasure& measure) {
  NamedPlot plot{collection.family + "-by-n-" + measure.name,
                 std::string(measure.title) + " against n", "medians over bins of n"};
  plot.x = "vertices n";
  plot.y = measure.unit(collection);
  LogRange x, y;
  std::vector<std::vector<std::pair<double, double>>> lines(collection.settings.size());
  std::set<std::int64_t> all_n;
  for (const auto& [key, one] : collection.graphs) all_n.insert(one.n);
  for (const SizeBin& bin : size_bins(all_n, kMostBins)) {
    std::vector<std::vector<double>> values(lines.size());
    std::vector<double> sizes;
    for (const auto& [key, one] : collection.graphs) {
      if (one.n < bin.first || one.n > bin.last) continue;
      sizes.push_back(log10_of(one.n));
      for (const auto& [setting, graph] : one.drawn) {
        const double value = measure.log10_value(collection, *graph);
        if (!std::isnan(value)) values[setting].push_back(value);
      }
    }
    const double middle = median(std::move(sizes));
    for (std::size_t s = 0; s < lines.size(); ++s) {
      if (values[s].empty()) continue;
      lines[s].emplace_back(middle, median(std::move(values[s])));
      x.include(middle);
      y.include(lines[s].back().second);
    }
  }
  if (y.empty()) return plot;
  const PlotFrame frame = frame_of(x, y, measure.ticks, plot.y);
  std::string svg = axes_svg(frame);
  std::vector<Label> labels;
  for (std::size_t s = 0; s < lines.size(); ++s) {
    if (lines[s].empty()) continue;
    std::string points;
    for (const auto& [log_n, value] : lines[s]) {
      points += frame.point(log_n, value);
      plot.csv += csv_line(collection.settings[s].label, "line", log_n, value);
    }
    svg += fmt::format("<polyline class='median {}' points='{}'/>", stroke_class(s), points);
    labels.push_back({kRight + 5, frame.y.pixel(lines[s].back().second) + 4,
                      collection.settings[s].label, fill_class(s)});
  }
  plot.svg = labelled_svg(plot.title, svg, std::move(labels));
  return plot;
}

}  // namespace ar3d::report
