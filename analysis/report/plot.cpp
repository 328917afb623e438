#include "ar3d/analysis/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kColours = 8;
constexpr double kResidualHeight = 92, kResidualTop = 8, kResidualBottom = 84;

std::string fill_class(std::size_t colour) { return fmt::format("f{}", colour % kColours); }

std::string bound_line(const Frame& frame, const std::vector<Series>& series) {
  for (const Series& one : series) {
    std::string points;
    for (const SizeSample& size : one.entry->all) {
      if (!std::isnan(size.log_bound))
        points += frame.point(log10_n(size), decimal(size.log_bound));
    }
    if (!points.empty()) return "<polyline class='bound' points='" + points + "'/>";
  }
  return "";
}

std::string median_line(const Frame& frame, const Series& series) {
  std::string points;
  for (const SizeSample& size : series.entry->all) {
    points += frame.point(log10_n(size), decimal(median(size.log_values())));
  }
  return fmt::format("<polyline class='median {}' points='{}'><title>{}</title></polyline>",
                     stroke_class(series.colour), points, escape(series.label));
}

std::string band(const Frame& frame, const Series& series) {
  const auto& all = series.entry->all;
  const bool has_width = std::any_of(
      all.begin(), all.end(), [](const SizeSample& size) { return size.instances.size() > 1; });
  if (!has_width) return "";
  std::string upper, lower;
  for (const SizeSample& size : all) {
    const std::vector<double> values = size.log_values();
    upper += frame.point(log10_n(size), decimal(quantile(values, 0.9)));
    lower.insert(0, frame.point(log10_n(size), decimal(quantile(values, 0.1))));
  }
  return fmt::format("<polygon class='band {}' points='{}{}'/>", fill_class(series.colour), upper,
                     lower);
}

std::string instance_points(const Frame& frame, const Series& series) {
  Dots dots, cut_off;
  for (const SizeSample& size : series.entry->all) {
    for (const InstanceValue& instance : shown_points(size)) {
      dots.add(frame.x.pixel(log10_n(size)), frame.y.pixel(decimal(instance.log_value)),
               instance.row);
    }
  }
  for (const CensoredRow& row : series.entry->censored) {
    cut_off.add(frame.x.pixel(std::log10(static_cast<double>(row.n))), kTop + 4, row.row);
  }
  return dots.svg("points " + stroke_class(series.colour)) + cut_off.svg("points cut");
}

std::string fitted_line(const Frame& frame, const Series& series) {
  const ScalingEntry& entry = *series.entry;
  if (!entry.decided || !entry.power.fitted) return "";
  std::string points;
  for (const SizeSample* size : {&entry.sizes.used.front(), &entry.sizes.used.back()}) {
    points +=
        frame.point(log10_n(*size), decimal(entry.power.log_value(static_cast<double>(size->n))));
  }
  return "<polyline class='fit' points='" + points + "'/>";
}

/// What one size leaves over from the fitted power law, as natural logarithms.
struct Residual {
  const SizeSample* size = nullptr;
  double mean = 0, low = 0, high = 0;
  bool used = false;
};

std::vector<Residual> residuals_of(const ScalingEntry& entry) {
  std::vector<Residual> residuals;
  for (const SizeSample& size : entry.all) {
    const double fitted = entry.power.log_value(static_cast<double>(size.n));
    const std::vector<double> values = size.log_values();
    const auto& used = entry.sizes.used;
    const bool is_used = std::any_of(used.begin(), used.end(),
                                     [&](const SizeSample& other) { return other.n == size.n; });
    residuals.push_back({&size, mean(values) - fitted, quantile(values, 0.1) - fitted,
                         quantile(values, 0.9) - fitted, is_used});
  }
  return residuals;
}

/// Half the height of the residual plot as a natural logarithm: a round factor, at least 1.05.
double residual_range(const std::vector<Residual>& residuals) {
  double largest = std::log(1.05);
  for (const Residual& r : residuals) {
    if (r.used) largest = std::max({largest, std::abs(r.low), std::abs(r.high)});
  }
  return largest * 1.1;
}

/// The row of the size whose value is closest to the size's mean: what a dot stands for.
std::size_t typical_row(const SizeSample& size) {
  const double centre = mean(size.log_values());
  return std::min_element(size.instances.begin(), size.instances.end(),
                          [&](const InstanceValue& a, const InstanceValue& b) {
                            return std::abs(a.log_value - centre) < std::abs(b.log_value - centre);
                          })
      ->row;
}

std::string factor_label(double y, double log) {
  return fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>×{:.2f}</text>", kLeft - 6, y + 4,
                     std::exp(log));
}

}  // namespace

std::string stroke_class(std::size_t colour) {
  return fmt::format("s{} d{}", colour % kColours, colour / kColours % 3);
}

void Dots::add(double x, double y, std::size_t row) {
  path += fmt::format("M{:.1f} {:.1f}h0", x, y);
  rows += fmt::format("{}{}", rows.empty() ? "" : " ", row);
}

std::string Dots::svg(const std::string& css) const {
  if (path.empty()) return "";
  return fmt::format("<path class='{}' d='{}' data-r='{}'/>", css, path, rows);
}

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

std::string svg_element(const std::string& title, double height, const std::string& content) {
  return fmt::format(
      "<svg class='plot' viewBox='0 0 {} {}' role='img' tabindex='0' aria-label='{}'>{}</svg>\n",
      kWidth, height, escape(title), content);
}

std::string scaling_svg(const std::vector<Series>& series, const std::string& title,
                        const Frame& frame, const PlotOptions& options) {
  std::string content = options.axes.empty() ? axes_svg(frame) : options.axes;
  if (options.points) content += band(frame, series.front());
  content += bound_line(frame, series);
  for (const Series& one : series) content += median_line(frame, one);
  if (options.points) {
    content += fitted_line(frame, series.front()) + instance_points(frame, series.front());
  }
  return svg_element(title, kHeight, content);
}

std::string residual_svg(const Series& series, const std::string& title, const Frame& frame) {
  const ScalingEntry& entry = *series.entry;
  if (!entry.decided || !entry.power.fitted) return "";
  const std::vector<Residual> residuals = residuals_of(entry);
  const double range = residual_range(residuals);
  const double middle = (kResidualTop + kResidualBottom) / 2;
  const auto pixel = [&](double log) {
    const double share = std::clamp(log / range, -1.0, 1.0);
    return middle - share * (kResidualBottom - kResidualTop) / 2;
  };
  std::string content = fmt::format(
      "<g class='grid'><path d='M{0} {1:.1f}H{2}'/><path class='minor' d='M{0} {3}H{2}M{0} "
      "{4}H{2}'/></g><g class='labels'>{5}{6}{7}</g>",
      kLeft, middle, kRight, kResidualTop, kResidualBottom, factor_label(kResidualTop, range),
      factor_label(middle, 0), factor_label(kResidualBottom, -range));
  std::string whiskers;
  Dots used, left_out;
  for (const Residual& r : residuals) {
    const double x = frame.x.pixel(log10_n(*r.size));
    if (r.high > r.low)
      whiskers += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, pixel(r.low), pixel(r.high));
    (r.used ? used : left_out).add(x, pixel(r.mean), typical_row(*r.size));
  }
  if (!whiskers.empty()) {
    content +=
        fmt::format("<path class='whisker s{}' d='{}'/>", series.colour % kColours, whiskers);
  }
  content += left_out.svg("points unused") + used.svg("points " + stroke_class(series.colour));
  return svg_element(title, kResidualHeight, content);
}

std::string bend_svg(const std::array<std::uint64_t, 8>& bends) {
  std::uint64_t total = 0;
  std::size_t used = 0;
  for (std::size_t b = 0; b < bends.size(); ++b) {
    total += bends[b];
    if (bends[b] > 0) used = b + 1;
  }
  if (total == 0) return "";
  std::string bars;
  for (std::size_t b = 0; b < used; ++b) {
    const double share = static_cast<double>(bends[b]) / static_cast<double>(total);
    const double width = 190 * share;
    const std::size_t y = 24 * b + 4;
    bars += fmt::format(
        "<text x='62' y='{}' text-anchor='end'>{}{} bend{}</text><rect x='70' y='{}' "
        "width='{:.1f}' height='16' rx='2'/><text x='{:.1f}' y='{}'>{}</text>",
        y + 12, b, b == 7 ? "+" : "", b == 1 ? "" : "s", y, width, 76 + width, y + 12,
        percent(share));
  }
  return fmt::format(
      "<svg class='plot bars' viewBox='0 0 360 {}' role='img' aria-label='edges by number of "
      "bends'>{}</svg>",
      24 * used + 4, bars);
}

}  // namespace ar3d::report
