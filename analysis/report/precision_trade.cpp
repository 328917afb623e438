// What accuracy costs: time against the largest miss by type and n, and against volume by effort.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/labels.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/precision.h"
#include "ar3d/analysis/report/settings.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostSizes = 4;  // in one figure

/// Medians of one type at one n: decimal logarithms.
struct Accuracy {
  std::size_t setting = 0;
  double log_time = kMissing;  ///< CPU time per vertex in seconds
  double log_miss = kMissing;
};

std::vector<Accuracy> accuracies(const RealRows& real, const std::string& family, std::int64_t n) {
  std::vector<Accuracy> all;
  for (std::size_t setting = 0; setting < real.settings.size(); ++setting) {
    std::vector<double> times;
    for (const RealRow& row : real.rows) {
      if (row.setting != setting || row.family != family || row.requested_n != n) continue;
      times.push_back(std::log10(row.cpu_s / static_cast<double>(row.n)));
    }
    const auto misses = median_misses(real, setting, family);
    const auto miss = misses.find(n);
    if (miss == misses.end() || !std::isfinite(miss->second)) continue;
    const Accuracy one{setting, median(std::move(times)), miss->second};
    if (std::isfinite(one.log_time)) all.push_back(one);
  }
  return all;
}

/// The steps of what no other type beats in both time and miss.
std::string front_svg(std::vector<Accuracy> points, std::int64_t n, const Frame& frame,
                      NamedPlot& plot) {
  std::sort(points.begin(), points.end(), [](const Accuracy& a, const Accuracy& b) {
    return std::pair(a.log_time, a.log_miss) < std::pair(b.log_time, b.log_miss);
  });
  std::string path;
  double least = std::numeric_limits<double>::infinity();
  for (const Accuracy& point : points) {
    if (point.log_miss >= least) continue;
    if (!path.empty()) path += frame.point(point.log_time, least);
    path += frame.point(point.log_time, point.log_miss);
    least = point.log_miss;
    plot.csv += csv_line(fmt::format("front at n = {}", n), "line", point.log_time, point.log_miss,
                         kMissing, kMissing);
  }
  return "<polyline class='front' points='" + path + "'/>";
}

/// At most kMostSizes of the sizes, evenly, the least and the largest among them.
std::vector<std::int64_t> shown_sizes(const RealRows& real, const std::string& family) {
  std::set<std::int64_t> sizes;
  for (const RealRow& row : real.rows) {
    if (row.family == family) sizes.insert(row.requested_n);
  }
  std::vector<std::int64_t> all(sizes.begin(), sizes.end());
  if (all.size() <= kMostSizes) return all;
  std::vector<std::int64_t> shown;
  for (std::size_t i = 0; i < kMostSizes; ++i) {
    shown.push_back(all[i * (all.size() - 1) / (kMostSizes - 1)]);
  }
  return shown;
}

/// One algorithm's efforts at an n: time and volume over those of its first effort, logarithms.
struct EffortLine {
  std::string label;
  std::int64_t n = 0;
  std::vector<std::pair<std::string, Median>> points;  // option, ratios
};

/// Efforts of one algorithm, and all families that any of them drew.
Group group_of(const std::vector<const Setting*>& efforts) {
  Group group{efforts, {}};
  for (const Setting* setting : efforts) {
    for (const auto& [n, families] : setting->sizes) {
      for (const auto& [family, medians] : families) group.families.insert(family);
    }
  }
  return group;
}

/// At the largest n that two efforts drew; no points if there is none.
EffortLine effort_line(const std::string& algorithm, const Group& group) {
  EffortLine line{algorithm, 0, {}};
  const std::vector<std::int64_t> sizes = group.sizes();
  for (auto n = sizes.rbegin(); n != sizes.rend() && line.points.empty(); ++n) {
    const Group there = group.at(*n);
    if (there.settings.size() < 2 || there.families.empty()) continue;
    line.n = *n;
    const Median first = over(*there.settings.front(), *n, there.families);
    for (const Setting* setting : there.settings) {
      const Median own = over(*setting, *n, there.families);
      line.points.emplace_back(setting->label,
                               Median{own.volume - first.volume, own.time - first.time});
    }
  }
  return line;
}

std::vector<EffortLine> effort_lines(const std::vector<Setting>& settings) {
  std::map<std::string, std::vector<const Setting*>> of_algorithm;
  for (const Setting& setting : settings) {
    const bool is_level = setting.label.find("level=") != std::string::npos;
    if (!is_level && setting.label.find("effort=") != std::string::npos) {
      of_algorithm[setting.algorithm].push_back(&setting);
    }
  }
  std::vector<EffortLine> lines;
  for (const auto& [algorithm, efforts] : of_algorithm) {
    EffortLine line = effort_line(algorithm, group_of(efforts));
    if (!line.points.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

NamedPlot accuracy_plot(const RealRows& real) {
  const std::string family = sample_family(real);
  NamedPlot plot{"accuracy-against-time", "What accuracy costs",
                 family +
                     ": medians, a line of types for each n; dashed: nothing is faster and "
                     "more accurate"};
  plot.x = "CPU time per vertex in s";
  plot.y = "largest miss in degrees";
  const std::vector<std::int64_t> sizes = shown_sizes(real, family);
  Range x, y;
  std::vector<std::vector<Accuracy>> all;
  for (const std::int64_t n : sizes) {
    all.push_back(accuracies(real, family, n));
    for (const Accuracy& point : all.back()) {
      x.include(point.log_time);
      y.include(point.log_miss);
    }
  }
  if (x.empty()) return plot;
  Frame frame = frame_of(x, y, TickStyle::power, plot.y);
  frame.x_ticks = TickStyle::seconds;
  frame.x_title = "CPU time per vertex";
  std::string svg = axes_svg(frame), marks;
  std::vector<Label> labels;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    svg += front_svg(all[i], sizes[i], frame, plot);
    for (const Accuracy& point : all[i]) {
      const double px = frame.x.pixel(point.log_time), py = frame.y.pixel(point.log_miss);
      marks += bend_mark(2, px, py, fill_class(point.setting));
      plot.csv += csv_line(fmt::format("{} at n = {}", real.settings[point.setting].name, sizes[i]),
                           "point", point.log_time, point.log_miss, kMissing, kMissing);
      if (i + 1 == sizes.size()) {
        labels.push_back(
            {kRight + 5, py + 4, real.settings[point.setting].name, fill_class(point.setting)});
      }
    }
    if (all[i].empty()) continue;
    labels.push_back({frame.x.pixel(all[i].front().log_time) + 7,
                      frame.y.pixel(all[i].front().log_miss) - 7, "n = " + grouped(sizes[i]),
                      "of-n"});
  }
  svg += marks + "<g class='ends'>" + labels_svg(std::move(labels), kTop + 26, kBottom) + "</g>";
  plot.svg = svg_element(plot.title, kLabelledWidth, kHeight, svg);
  return plot;
}

NamedPlot effort_plot(const std::vector<Section>& sections) {
  const std::vector<Setting> settings = settings_of(sections);
  const std::vector<EffortLine> lines = effort_lines(settings);
  NamedPlot plot{"effort", "What effort buys",
                 "time and volume over those of the algorithm's first effort, at its largest n"};
  plot.x = "times the drawing time";
  plot.y = "times the volume";
  Range x, y;
  for (const EffortLine& line : lines) {
    for (const auto& [label, ratios] : line.points) {
      x.include(ratios.time);
      y.include(ratios.volume);
    }
  }
  if (x.empty() || y.empty()) return plot;
  Frame frame = frame_of(x, y, TickStyle::power, plot.y);
  frame.x_ticks = frame.y_ticks = TickStyle::count;
  frame.x_title = plot.x;
  std::string svg = axes_svg(frame);
  std::vector<Label> labels;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string points, marks;
    for (const auto& [label, ratios] : lines[i].points) {
      if (std::isnan(ratios.time)) continue;
      points += frame.point(ratios.time, ratios.volume);
      const double px = frame.x.pixel(ratios.time), py = frame.y.pixel(ratios.volume);
      marks += bend_mark(2, px, py, fill_class(i));
      labels.push_back({px + 7, py - 4, label.substr(label.find('=') + 1, 1), fill_class(i)});
      plot.csv += csv_line(label, "point", ratios.time, ratios.volume, kMissing, kMissing);
    }
    svg +=
        fmt::format("<polyline class='median {}' points='{}'/>", stroke_class(i), points) + marks;
    labels.push_back({kRight + 5, kTop + 12 + 14 * static_cast<double>(i),
                      fmt::format("{}, n = {}", lines[i].label, grouped(lines[i].n)),
                      fill_class(i)});
  }
  svg += "<g class='ends'>" + labels_svg(std::move(labels), kTop + 8, kBottom) + "</g>";
  plot.svg = svg_element(plot.title, kLabelledWidth, kHeight, svg);
  return plot;
}

}  // namespace ar3d::report
