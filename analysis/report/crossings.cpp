// Volume against n, and where one algorithm begins to need less than another.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/labels.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/settings.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostCrossings = 8;  // told in words

struct Line {
  const Setting* setting = nullptr;
  std::vector<std::pair<double, double>> points;  // log n, log volume - order * log n
};

/// At each n over the families that all settings with this n drew there.
std::vector<Line> volume_lines(const Group& group, double order) {
  std::vector<Line> lines;
  for (const Setting* setting : group.settings) lines.push_back({setting, {}});
  for (const std::int64_t n : group.sizes()) {
    const Group there = group.at(n);
    if (there.families.empty()) continue;
    for (Line& line : lines) {
      if (!line.setting->sizes.contains(n)) continue;
      const double volume = over(*line.setting, n, there.families).volume;
      line.points.emplace_back(log10_of(n), volume - order * log10_of(n));
    }
  }
  std::erase_if(lines, [](const Line& line) { return line.points.empty(); });
  return lines;
}

/// Where line `a` falls below line `b` for good within their common sizes.
struct Crossing {
  const Line* below = nullptr;
  const Line* above = nullptr;
  double log_n = 0, value = 0;
};

void add_crossing(const Line& a, const Line& b, std::vector<Crossing>& crossings) {
  std::map<double, double> other(b.points.begin(), b.points.end());
  double last_n = kMissing, last_gap = kMissing, last_value = kMissing;
  Crossing found;
  for (const auto& [log_n, value] : a.points) {
    const auto at = other.find(log_n);
    if (at == other.end()) continue;
    const double gap = value - at->second;
    if (!std::isnan(last_gap) && (gap < 0) != (last_gap < 0) && gap != last_gap) {
      const double part = last_gap / (last_gap - gap);
      found = {gap < 0 ? &a : &b, gap < 0 ? &b : &a, last_n + part * (log_n - last_n),
               last_value + part * (value - last_value)};
    }
    last_n = log_n, last_gap = gap, last_value = value;
  }
  if (found.below != nullptr) crossings.push_back(found);
}

/// The last crossing of every two lines of different algorithms.
std::vector<Crossing> crossings_of(const std::vector<Line>& lines) {
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (lines[i].setting->algorithm == lines[j].setting->algorithm) continue;
      add_crossing(lines[i], lines[j], crossings);
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.log_n < b.log_n; });
  return crossings;
}

std::string crossing_sentences(const std::vector<Crossing>& crossings) {
  if (crossings.empty()) return "";
  std::string html = "<ul class=crossings>";
  for (std::size_t i = 0; i < std::min(kMostCrossings, crossings.size()); ++i) {
    const Crossing& crossing = crossings[i];
    html +=
        fmt::format("<li>{} needs less volume than {} from about n = {} on</li>",
                    escape(crossing.below->setting->label), escape(crossing.above->setting->label),
                    grouped(std::llround(std::pow(10, crossing.log_n))));
  }
  return html + "</ul>";
}

NamedPlot plot_of(const Group& group, const std::vector<Line>& lines, double order) {
  const std::string divisor = fmt::format("n^{:.3g}", order);
  NamedPlot plot{"volume", "Volume against n",
                 fmt::format("divided by {}; medians over {}", divisor, group.text())};
  plot.x = "vertices n";
  plot.y = "volume / " + divisor;
  Range x, y;
  for (const Line& line : lines) {
    for (const auto& [log_n, value] : line.points) {
      x.include(log_n);
      y.include(value);
    }
  }
  const Frame frame = frame_of(x, y, TickStyle::power, plot.y);
  std::string svg = axes_svg(frame);
  std::vector<Label> labels;
  for (const Line& line : lines) {
    std::string points;
    for (const auto& [log_n, value] : line.points) {
      points += frame.point(log_n, value);
      plot.csv += csv_line(line.setting->label, "line", log_n, value, kMissing, kMissing);
    }
    svg += fmt::format("<polyline class='median {}' points='{}'/>",
                       stroke_class(line.setting->colour), points);
    labels.push_back({kRight + 5, frame.y.pixel(line.points.back().second) + 4, line.setting->label,
                      fill_class(line.setting->colour)});
  }
  for (const Crossing& crossing : crossings_of(lines)) {
    svg += fmt::format("<circle class='crossing' cx='{:.1f}' cy='{:.1f}' r='4'/>",
                       frame.x.pixel(crossing.log_n), frame.y.pixel(crossing.value));
    plot.csv +=
        csv_line(crossing.below->setting->label + " below " + crossing.above->setting->label,
                 "point", crossing.log_n, crossing.value, kMissing, kMissing);
  }
  svg += "<g class='ends'>" + labels_svg(std::move(labels), kTop + 8, kBottom) + "</g>";
  plot.svg = svg_element(plot.title, kLabelledWidth, kHeight, svg);
  plot.legend = crossing_sentences(crossings_of(lines));
  return plot;
}

}  // namespace

NamedPlot volume_plot(const Group& group, double order) {
  const std::vector<Line> lines = volume_lines(group, order);
  return lines.size() < 2 ? NamedPlot{} : plot_of(group, lines, order);
}

}  // namespace ar3d::report
