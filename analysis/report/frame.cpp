#include "ar3d/analysis/report/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ar3d/analysis/report/html.h"

namespace ar3d::report {
namespace {

constexpr int kMostTicks = 6;

const char* grid_class(const Tick& tick) { return tick.label.empty() ? " class='minor'" : ""; }

}  // namespace

double decimal(double natural_log) { return natural_log / std::numbers::ln10; }
double log10_of(std::int64_t n) { return std::log10(static_cast<double>(n)); }

void Range::include(double value) {
  if (std::isnan(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

std::string Frame::point(double log10_x, double log10_y) const {
  return fmt::format("{:.1f},{:.1f} ", x.pixel(log10_x), y.pixel(log10_y));
}

Frame frame_of(const Range& x, const Range& y, TickStyle y_ticks, const std::string& y_title) {
  return {LogAxis(x.low, x.high, kLeft, kRight),
          LogAxis(y.low, y.high, kBottom, kTop + (y_title.empty() ? 0 : 16)),
          TickStyle::count,
          y_ticks,
          "vertices n",
          y_title};
}

std::string axes_svg(const Frame& frame) {
  std::string grid, labels;
  for (const Tick& tick : frame.x.ticks(frame.x_ticks, kMostTicks)) {
    const double x = frame.x.pixel(tick.log10);
    grid += fmt::format("<path d='M{:.1f} {}V{}'{}/>", x, kTop, kBottom, grid_class(tick));
    if (tick.label.empty()) continue;
    labels += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>{}</text>", x, kBottom + 16,
                          tick.label);
  }
  for (const Tick& tick : frame.y.ticks(frame.y_ticks, kMostTicks)) {
    const double y = frame.y.pixel(tick.log10);
    grid += fmt::format("<path d='M{} {:.1f}H{}'{}/>", kLeft, y, kRight, grid_class(tick));
    if (tick.label.empty()) continue;
    labels += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>{}</text>", kLeft - 6, y + 4,
                          tick.label);
  }
  labels += fmt::format("<text x='{}' y='{}' text-anchor='middle'>{}</text>", (kLeft + kRight) / 2,
                        kBottom + 34, escape(frame.x_title));
  if (!frame.y_title.empty()) {
    labels +=
        fmt::format("<text x='{}' y='{}'>{}</text>", kLeft + 4, kTop + 11, escape(frame.y_title));
  }
  return "<g class='grid'>" + grid + "</g><g class='labels'>" + labels + "</g>";
}

}  // namespace ar3d::report
