#include "ar3d/analysis/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ar3d/analysis/report/html.h"

namespace ar3d::report {
namespace {
constexpr std::size_t kColours = 8;
}  // namespace

std::string stroke_class(std::size_t colour) {
  return fmt::format("s{} d{}", colour % kColours, colour / kColours % 3);
}

std::string fill_class(std::size_t colour) { return fmt::format("f{}", colour % kColours); }

void Dots::add(double x, double y, std::size_t row) {
  path += fmt::format("M{:.1f} {:.1f}h0", x, y);
  rows += fmt::format("{}{}", rows.empty() ? "" : " ", row);
}

std::string Dots::svg(const std::string& css) const {
  if (path.empty()) return "";
  return fmt::format("<path class='{}' d='{}' data-r='{}'/>", css, path, rows);
}

std::vector<InstanceValue> shown_points(const SizeSample& size, std::size_t most) {
  std::vector<InstanceValue> sorted = size.instances;
  std::stable_sort(
      sorted.begin(), sorted.end(),
      [](const InstanceValue& a, const InstanceValue& b) { return a.log_value < b.log_value; });
  if (sorted.size() <= most) return sorted;
  if (most < 2) return {sorted.back()};
  std::vector<InstanceValue> shown;
  for (std::size_t i = 0; i < most; ++i) {
    shown.push_back(sorted[i * (sorted.size() - 1) / (most - 1)]);
  }
  return shown;
}

std::string bend_mark(std::size_t bends, double x, double y, const std::string& css) {
  const char* shape = "a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0";  // from its left
  double dx = -4.5, dy = 0;
  if (bends == 3) shape = "l5 9h-10z", dx = 0, dy = -5;
  if (bends == 4) shape = "h8v8h-8z", dx = dy = -4;
  if (bends == 5) shape = "l5.5 5.5l-5.5 5.5l-5.5 -5.5z", dx = 0, dy = -5.5;
  if (bends > 5) shape = "h4v-4h2v4h4v2h-4v4h-2v-4h-4z", dx = -5, dy = -1;
  return fmt::format("<path class='{}' d='M{:.1f} {:.1f}{}'/>", css, x + dx, y + dy, shape);
}

std::string svg_element(const std::string& title, double width, double height,
                        const std::string& content) {
  return fmt::format(
      "<svg class='plot' viewBox='0 0 {} {}' role='img' tabindex='0' aria-label='{}'>{}</svg>\n",
      width, height, escape(title), content);
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
