#include "ar3d/analysis/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr double kWidth = 360, kHeight = 244;
constexpr double kLeft = 50, kRight = 350, kTop = 10, kBottom = 204;
constexpr std::size_t kColours = 8;

double decimal(double natural_log) { return natural_log / std::numbers::ln10; }
double log10_n(const SizeSample& size) { return std::log10(static_cast<double>(size.n)); }

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value) {
    if (std::isnan(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Both axes, fitted to everything the plot will show.
struct Frame {
  LogAxis x;
  LogAxis y;
  std::string point(double log10_x, double log10_y) const {
    return fmt::format("{:.1f},{:.1f} ", x.pixel(log10_x), y.pixel(log10_y));
  }
};

Frame make_frame(const std::vector<Series>& series) {
  Range x, y;
  for (const Series& one : series) {
    for (const SizeSample& size : one.entry->all) {
      x.include(log10_n(size));
      y.include(decimal(size.log_bound));
      for (const InstanceValue& instance : size.instances) y.include(decimal(instance.log_value));
    }
  }
  return {LogAxis(x.low, x.high, kLeft, kRight), LogAxis(y.low, y.high, kBottom, kTop)};
}

std::string axes(const Frame& frame, const PlotOptions& options) {
  std::string svg = "<g class=grid>";
  std::string labels;
  for (const Tick& tick : frame.x.ticks(TickStyle::count, 6)) {
    const double x = frame.x.pixel(tick.log10);
    svg += fmt::format("<path d='M{:.1f} {}V{}'{} />", x, kTop, kBottom,
                       tick.label.empty() ? " class=minor" : "");
    labels += fmt::format("<text x={:.1f} y={} text-anchor=middle>{}</text>", x, kBottom + 16,
                          tick.label);
  }
  for (const Tick& tick : frame.y.ticks(options.y_ticks, 6)) {
    const double y = frame.y.pixel(tick.log10);
    svg += fmt::format("<path d='M{} {:.1f}H{}'{} />", kLeft, y, kRight,
                       tick.label.empty() ? " class=minor" : "");
    labels +=
        fmt::format("<text x={} y={:.1f} text-anchor=end>{}</text>", kLeft - 6, y + 4, tick.label);
  }
  labels += fmt::format("<text x={} y={} text-anchor=middle>vertices n</text>",
                        (kLeft + kRight) / 2, kBottom + 34);
  return svg + "</g><g class=labels>" + labels + "</g>";
}

std::string bound_line(const Frame& frame, const std::vector<Series>& series) {
  for (const Series& one : series) {
    std::string points;
    for (const SizeSample& size : one.entry->all) {
      if (!std::isnan(size.log_bound))
        points += frame.point(log10_n(size), decimal(size.log_bound));
    }
    if (!points.empty()) return "<polyline class=bound points='" + points + "'/>";
  }
  return "";
}

std::string median_line(const Frame& frame, const Series& series) {
  std::string points;
  for (const SizeSample& size : series.entry->all) {
    points += frame.point(log10_n(size), decimal(median(size.log_values())));
  }
  return fmt::format("<polyline class='median s{} d{}' points='{}'><title>{}</title></polyline>",
                     series.colour % kColours, series.colour / kColours % 3, points,
                     escape(series.label));
}

std::string band(const Frame& frame, const Series& series) {
  std::string upper, lower;
  for (const SizeSample& size : series.entry->all) {
    const std::vector<double> values = size.log_values();
    upper += frame.point(log10_n(size), decimal(quantile(values, 0.9)));
    lower.insert(0, frame.point(log10_n(size), decimal(quantile(values, 0.1))));
  }
  return fmt::format("<polygon class='band f{}' points='{}{}'/>", series.colour % kColours, upper,
                     lower);
}

std::string instance_points(const Frame& frame, const Series& series) {
  std::string svg = fmt::format("<g class='points f{}'>", series.colour % kColours);
  for (const SizeSample& size : series.entry->all) {
    for (const InstanceValue& instance : shown_points(size)) {
      svg += fmt::format("<circle cx={:.1f} cy={:.1f} r=2.2 data-r={} />",
                         frame.x.pixel(log10_n(size)), frame.y.pixel(decimal(instance.log_value)),
                         instance.row);
    }
  }
  return svg + "</g>";
}

std::string fitted_line(const Frame& frame, const Series& series) {
  const ScalingEntry& entry = *series.entry;
  if (!entry.decided || !entry.power.fitted) return "";
  std::string points;
  for (const SizeSample* size : {&entry.sizes.used.front(), &entry.sizes.used.back()}) {
    points +=
        frame.point(log10_n(*size), decimal(entry.power.log_value(static_cast<double>(size->n))));
  }
  return "<polyline class=fit points='" + points + "'/>";
}

}  // namespace

std::vector<InstanceValue> shown_points(const SizeSample& size) {
  std::vector<InstanceValue> sorted = size.instances;
  std::stable_sort(
      sorted.begin(), sorted.end(),
      [](const InstanceValue& a, const InstanceValue& b) { return a.log_value < b.log_value; });
  if (sorted.size() <= kPointsPerSize) return sorted;
  std::vector<InstanceValue> shown;
  for (std::size_t i = 0; i < kPointsPerSize; ++i) {
    shown.push_back(sorted[i * (sorted.size() - 1) / (kPointsPerSize - 1)]);
  }
  return shown;
}

std::string scaling_svg(const std::vector<Series>& series, const std::string& title,
                        const PlotOptions& options) {
  if (series.empty()) return "";
  const Frame frame = make_frame(series);
  std::string svg =
      fmt::format("<svg class=plot viewBox='0 0 {} {}' role=img tabindex=0 aria-label='{}'>",
                  kWidth, kHeight, escape(title));
  svg += axes(frame, options);
  if (options.points) svg += band(frame, series.front());
  svg += bound_line(frame, series);
  for (const Series& one : series) svg += median_line(frame, one);
  if (options.points) {
    svg += fitted_line(frame, series.front()) + instance_points(frame, series.front());
  }
  return svg + "</svg>\n";
}

}  // namespace ar3d::report
