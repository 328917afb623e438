#include "ar3d/analysis/history/line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ar3d/analysis/history/changes_in_order.h"
#include "ar3d/analysis/report/frame.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"

namespace ar3d {
namespace {

using report::escape;
using report::Range;

constexpr double kLeft = report::kLeft + 6, kRight = report::kLabelledWidth - 14;
constexpr double kTop = 16, kBottom = report::kBottom - 14;
constexpr double kLeastHeight = 0.02;  // of the values: less is not stretched to the whole height
constexpr std::size_t kMostNames = 6;

/// From the number of a value, and the value, to pixels: both linear.
struct Scale {
  double left = 0, right = 0, top = 0, bottom = 0;
  double last = 1;  ///< number of the last value, at least 1
  double low = 0, high = 1;
  double x(double index) const { return left + index / last * (right - left); }
  double y(double value) const { return bottom - (value - low) / (high - low) * (bottom - top); }
};

Scale scale_of(const HistoryLine& line, double left, double right, double top, double bottom) {
  Range range;
  for (const double value : line.values) range.include(value);
  const double middle = (range.low + range.high) / 2;
  const double least = middle > 0 ? kLeastHeight * middle : 1;
  const double half = std::max(range.high - range.low, least) / 2;
  const auto last = static_cast<double>(std::max<std::size_t>(line.values.size(), 2) - 1);
  return {left, right, top, bottom, last, middle - half, middle + half};
}

std::string polyline(const HistoryLine& line, const Scale& scale, const char* css) {
  std::string points;
  for (std::size_t i = 0; i < line.values.size(); ++i) {
    points +=
        fmt::format("{:.1f},{:.1f} ", scale.x(static_cast<double>(i)), scale.y(line.values[i]));
  }
  return fmt::format("<polyline class='{}' points='{}'/>", css, points);
}

/// Between value i - 1 and value i.
double before(std::size_t i) { return static_cast<double>(i) - 0.5; }

std::string change_marks(const HistoryLine& line, const Scale& scale) {
  std::string svg;
  for (const ChangePoint& change : line.changes) {
    const double first = scale.x(before(change.first)), last = scale.x(before(change.last));
    svg += fmt::format(
        "<rect class='band f1' x='{:.1f}' y='{}' width='{:.1f}' height='{}'/>"
        "<path class='bound' d='M{:.1f} {}V{}'/>",
        std::max(first - 1, scale.left), scale.top, std::max(last - first, 0.0) + 2,
        scale.bottom - scale.top, scale.x(before(change.at)), scale.top, scale.bottom);
  }
  return svg;
}

/// The median between every two changes.
std::string levels(const HistoryLine& line, const Scale& scale) {
  std::string svg;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.changes.size(); ++i) {
    const std::size_t end = i < line.changes.size() ? line.changes[i].at : line.values.size();
    const double y = scale.y(median({line.values.begin() + static_cast<std::ptrdiff_t>(begin),
                                     line.values.begin() + static_cast<std::ptrdiff_t>(end)}));
    svg += fmt::format("<polyline class='median s0' points='{:.1f},{:.1f} {:.1f},{:.1f}'/>",
                       scale.x(static_cast<double>(begin)), y,
                       scale.x(static_cast<double>(end - 1)), y);
    begin = end;
  }
  return svg;
}

std::string dots(const History& history, const HistoryLine& line, const Scale& scale) {
  std::string svg;
  for (std::size_t i = 0; i < line.values.size(); ++i) {
    svg += fmt::format(
        "<circle class='f0' cx='{:.1f}' cy='{:.1f}' r='2.6'><title>{}: {}</title>"
        "</circle>",
        scale.x(static_cast<double>(i)), scale.y(line.values[i]),
        escape(history.results[line.results[i]].name), value_text(line.measure, line.values[i]));
  }
  return svg;
}

/// Lines across at round percentages of the first value, or at the values where that is 0.
std::string value_grid(const HistoryLine& line, const Scale& scale) {
  const double unit = line.values.front() > 0 ? line.values.front() : 1;
  const double reach = (scale.high - scale.low) / unit;
  double step = std::pow(10, std::floor(std::log10(reach / 2)));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (reach / step > 6) step *= factor;
  }
  std::string svg;
  const double zero = line.values.front() > 0 ? 1 : 0;
  const double first = std::ceil((scale.low / unit - zero) / step);
  for (double i = first; zero + i * step <= scale.high / unit + 1e-9; ++i) {
    const double y = scale.y((zero + i * step) * unit);
    const std::string label =
        zero > 0 ? fmt::format("{:+.3g} %", 100 * i * step + 0.0) : fmt::format("{:.3g}", i * step);
    svg += fmt::format(
        "<path d='M{} {:.1f}H{}'/><text x='{}' y='{:.1f}' text-anchor='end'>{}</text>", scale.left,
        y, scale.right, scale.left - 6, y + 4, i == 0 && zero > 0 ? "±0 %" : label);
  }
  return svg;
}

std::string commit_names(const History& history, const HistoryLine& line, const Scale& scale) {
  std::string svg;
  const std::size_t step = (line.values.size() + kMostNames - 1) / kMostNames;
  for (std::size_t i = 0; i < line.values.size(); i += step) {
    svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>",
                       scale.x(static_cast<double>(i)), scale.bottom + 18,
                       escape(history.results[line.results[i]].name.substr(0, 8)));
  }
  return svg;
}

}  // namespace

std::string line_figure(const History& history, const HistoryLine& line) {
  const Scale scale = scale_of(line, kLeft, kRight, kTop, kBottom);
  const std::string title =
      fmt::format("{} of {}", to_string(line.measure), cell_label(line.cell.curve, line.cell.n));
  const std::string content =
      "<g class='grid labels'>" + value_grid(line, scale) + commit_names(history, line, scale) +
      fmt::format("<text x='{}' y='{}' text-anchor='middle'>commits</text>", (kLeft + kRight) / 2,
                  kBottom + 36) +
      "</g>" + change_marks(line, scale) + levels(line, scale) + dots(history, line, scale);
  std::string note =
      fmt::format("first value {}; environment {}", value_text(line.measure, line.values.front()),
                  line.environment + 1);
  for (const ChangePoint& change : line.changes) {
    note += fmt::format("; {}{}", effect_text(line, change), change.gradual ? " (gradual)" : "");
  }
  return fmt::format("<figure><figcaption><b>{}</b> <span>{}</span></figcaption>{}</figure>\n",
                     escape(title), escape(note),
                     report::svg_element(title + " over commits", report::kLabelledWidth,
                                         report::kHeight, content));
}

std::string sparkline(const History& history, const HistoryLine& line) {
  constexpr double kWidth = 132, kHeight = 30;
  const Scale scale = scale_of(line, 3, kWidth - 3, 4, kHeight - 4);
  const std::string from = history.results[line.results.front()].name;
  const std::string to = history.results[line.results.back()].name;
  const std::string title = fmt::format("{} of {}: {} ({}) to {} ({})", to_string(line.measure),
                                        cell_label(line.cell.curve, line.cell.n),
                                        value_text(line.measure, line.values.front()), from,
                                        value_text(line.measure, line.values.back()), to);
  return fmt::format(
      "<svg class='spark' viewBox='0 0 {} {}' role='img' tabindex='0'><title>{}</title>{}{}</svg>",
      kWidth, kHeight, escape(title), change_marks(line, scale),
      polyline(line, scale, "median s0"));
}

}  // namespace ar3d
