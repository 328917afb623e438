// Pictures of the report as SVG: logarithmic axes, the frame around the data, marks, and names at
// the ends of lines that give way to each other.
#include "ar3d/analysis/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "ar3d/analysis/report/html.h"

namespace ar3d::report {

namespace {

constexpr double kNarrow = 0.7;  // decades: too few ticks 1, 2, 5 below
constexpr double kAir = 0.04;    // share of the range left free at either end

std::string superscript(int exponent) {
  static const std::array<const char*, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                      "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) {
    text += kDigits.at(static_cast<std::size_t>(digit - '0'));
  }
  return text;
}

/// "2", "20", "200", "2k", … : digit * 10^exponent with an SI prefix.
std::string si(int digit, int exponent, const char* unit, bool spaced) {
  static const std::array<const char*, 9> kPrefixes = {"p", "n", "µ", "m", "", "k", "M", "G", "T"};
  const int group = exponent >= 0 ? exponent / 3 : -((2 - exponent) / 3);
  if (group < -4 || group > 4) return fmt::format("{}·10{}", digit, superscript(exponent));
  const int value = digit * static_cast<int>(std::lround(std::pow(10, exponent - 3 * group)));
  return fmt::format("{}{}{}{}", value, spaced ? " " : "",
                     kPrefixes.at(static_cast<std::size_t>(4L + group)), unit);
}

std::string label(int digit, int exponent, TickStyle style) {
  switch (style) {
    case TickStyle::count:
      if (exponent < 0 && exponent >= -3) {  // 1.5, not 1500m
        return fmt::format("{:.{}f}", digit * std::pow(10, exponent), -exponent);
      }
      return si(digit, exponent, "", false);
    case TickStyle::seconds:
      return si(digit, exponent, "s", true);
    case TickStyle::share:
    case TickStyle::power:
      break;
  }
  if (exponent >= 0 && exponent < 3) {
    return std::to_string(digit * static_cast<int>(std::lround(std::pow(10, exponent))));
  }
  return digit == 1 ? "10" + superscript(exponent)
                    : fmt::format("{}·10{}", digit, superscript(exponent));
}

/// digits / 10 * 10^exponent, digits in [10, 99].
std::string two_digit_label(int digits, int exponent, TickStyle style) {
  if (digits % 10 == 0) return label(digits / 10, exponent, style);
  if (style == TickStyle::power && exponent >= 3) {
    return fmt::format("{:.1f}·10{}", digits / 10.0, superscript(exponent));
  }
  return label(digits, exponent - 1, style);
}

}  // namespace

LogAxis::LogAxis(double low, double high, double first_pixel, double last_pixel)
    : low_(low), high_(high), first_pixel_(first_pixel), last_pixel_(last_pixel) {
  if (high_ - low_ < 1e-6) {
    low_ -= 0.5;
    high_ += 0.5;
  }
  const double air = kAir * (high_ - low_);
  low_ -= air;
  high_ += air;
}

double LogAxis::pixel(double log10) const {
  return first_pixel_ + (log10 - low_) / (high_ - low_) * (last_pixel_ - first_pixel_);
}

std::vector<Tick> LogAxis::ticks(TickStyle style, int most) const {
  if (style == TickStyle::share) {
    return {{0, "0 %"}, {0.25, "25 %"}, {0.5, "50 %"}, {0.75, "75 %"}, {1, "100 %"}};
  }
  const double decades = high_ - low_;
  if (decades < kNarrow) {
    std::vector<Tick> narrow = narrow_ticks(style, most);
    if (!narrow.empty()) return narrow;
  }
  const int first = static_cast<int>(std::floor(low_));
  const int last = static_cast<int>(std::ceil(high_));
  int step = std::max(1, static_cast<int>(std::ceil(decades / most)));
  if (step > 5) step = step <= 10 ? 10 : (step + 19) / 20 * 20;
  std::vector<Tick> ticks;
  for (int exponent = first; exponent <= last; ++exponent) {
    for (const int digit : {1, 2, 5}) {
      const double place = exponent + std::log10(digit);
      if (place < low_ || place > high_ || (digit != 1 && decades > 4)) continue;
      const bool is_labelled = digit == 1 ? exponent % step == 0 : 3 * decades <= most;
      if (!is_labelled && step > 5) continue;
      ticks.push_back({place, is_labelled ? label(digit, exponent, style) : ""});
    }
  }
  return ticks;
}

std::vector<Tick> LogAxis::narrow_ticks(TickStyle style, int most) const {
  for (const int step : {1, 2, 5, 10}) {  // of numbers of two digits
    std::vector<Tick> ticks;
    const int last = static_cast<int>(std::floor(high_));
    for (int exponent = static_cast<int>(std::floor(low_)); exponent <= last; ++exponent) {
      for (int digits = 10; digits < 100; digits += step) {
        const double place = exponent + std::log10(digits / 10.0);
        if (place >= low_ && place <= high_) {
          ticks.push_back({place, two_digit_label(digits, exponent, style)});
        }
      }
    }
    if (ticks.size() <= static_cast<std::size_t>(most)) return ticks;
  }
  return {};
}

namespace {

constexpr int kMostTicks = 6;

const char* grid_class(const Tick& tick) { return tick.label.empty() ? " class='minor'" : ""; }

}  // namespace

double decimal(double natural_log) { return natural_log / std::numbers::ln10; }
double log10_of(std::int64_t n) { return std::log10(static_cast<double>(n)); }

void LogRange::include(double value) {
  if (std::isnan(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

std::string PlotFrame::point(double log10_x, double log10_y) const {
  return fmt::format("{:.1f},{:.1f} ", x.pixel(log10_x), y.pixel(log10_y));
}

PlotFrame frame_of(const LogRange& x, const LogRange& y, TickStyle y_ticks,
                   const std::string& y_title) {
  return {LogAxis(x.low, x.high, kLeft, kRight),
          LogAxis(y.low, y.high, kBottom, kTop + (y_title.empty() ? 0 : 16)),
          TickStyle::count,
          y_ticks,
          "vertices n",
          y_title};
}

std::string axes_svg(const PlotFrame& frame) {
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
  return evenly(sorted, most);
}

std::string bend_mark(std::size_t bends, double x, double y, const std::string& css) {
  const char* shape = "a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0";  // from its left
  double dx = -4.5, dy = 0;
  if (bends == 0) shape = "h10v4h-10z", dx = -5, dy = -2;
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

namespace {

constexpr double kLine = 11.5;  // between two labels
constexpr double kReach = 100;  // labels further apart than this do not touch

/// UTF-8 text cut to kLabelCharacters, of which `tail` are its last ones.
std::string cut(const std::string& text, std::size_t tail) {
  std::vector<std::size_t> starts;  // of characters, not bytes
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) starts.push_back(i);
  }
  if (starts.size() <= kLabelCharacters) return text;
  const std::size_t end = tail == 0 ? text.size() : starts[starts.size() - tail];
  return text.substr(0, starts[kLabelCharacters - tail]) + "…" + text.substr(end);
}

/// The labels' texts, cut so that different ones stay different: at the end, else in the middle,
/// else not at all.
std::vector<std::string> cut_texts(const std::vector<Label>& labels) {
  std::set<std::string> whole;
  for (const Label& label : labels) whole.insert(label.text);
  for (const std::size_t tail : {0u, 7u, 12u}) {
    std::set<std::string> different;
    for (const std::string& text : whole) different.insert(cut(text, tail));
    if (different.size() < whole.size()) continue;
    std::vector<std::string> texts;
    for (const Label& label : labels) texts.push_back(cut(label.text, tail));
    return texts;
  }
  std::vector<std::string> texts;
  for (const Label& label : labels) texts.push_back(label.text);
  return texts;
}

bool touch(const Label& a, const Label& b) { return std::abs(a.x - b.x) < kReach; }

void push_down(std::vector<Label>& labels) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (touch(labels[i], labels[j])) {
        labels[i].y = std::max(labels[i].y, labels[j].y + kLine);
      }
    }
  }
}

void push_up(double bottom, std::vector<Label>& labels) {
  for (std::size_t i = labels.size(); i-- > 0;) {
    labels[i].y = std::min(labels[i].y, bottom);
    for (std::size_t j = i + 1; j < labels.size(); ++j) {
      if (touch(labels[i], labels[j])) {
        labels[i].y = std::min(labels[i].y, labels[j].y - kLine);
      }
    }
  }
}

}  // namespace

std::string labels_svg(std::vector<Label> labels, double top, double bottom) {
  for (Label& label : labels) label.y = std::max(label.y, top);
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Label& a, const Label& b) { return a.y < b.y; });
  push_down(labels);
  push_up(bottom, labels);
  const std::vector<std::string> texts = cut_texts(labels);
  std::string svg;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Label& label = labels[i];
    svg += fmt::format("<text class='{}' x='{:.1f}' y='{:.1f}'>{}<title>{}</title></text>",
                       label.css, label.x, label.y, escape(texts[i]), escape(label.text));
  }
  return svg;
}

std::string labelled_svg(const std::string& title, const std::string& content,
                         std::vector<Label> labels, double top) {
  return svg_element(
      title, kLabelledWidth, kHeight,
      content + "<g class='ends'>" + labels_svg(std::move(labels), top, kBottom) + "</g>");
}

std::string SizeBin::text() const {
  return first == last ? grouped(first) : grouped(first) + " – " + grouped(last);
}

std::vector<SizeBin> size_bins(const std::set<std::int64_t>& sizes, std::size_t most) {
  std::vector<SizeBin> bins;
  if (sizes.empty()) return bins;
  const double low = log10_of(std::max<std::int64_t>(1, *sizes.begin()));
  const double width = (log10_of(*sizes.rbegin()) - low) / static_cast<double>(most);
  std::size_t end_of_last = 0;  // parts up to the last bin's end
  for (const std::int64_t n : sizes) {
    const double place = (log10_of(std::max<std::int64_t>(1, n)) - low) / width;
    const std::size_t end = std::min(static_cast<std::size_t>(std::max(0.0, place)), most - 1) + 1;
    if (sizes.size() <= most || end > end_of_last) bins.push_back({n, n});
    bins.back().last = n;
    end_of_last = end;
  }
  return bins;
}

std::vector<std::pair<double, double>> front_of(std::vector<std::pair<double, double>> points) {
  std::sort(points.begin(), points.end());
  std::vector<std::pair<double, double>> front;
  for (const auto& point : points) {
    if (front.empty() || point.second < front.back().second) front.push_back(point);
  }
  return front;
}

std::string front_svg(const std::vector<std::pair<double, double>>& front, const PlotFrame& frame) {
  std::string path;
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (i > 0) path += frame.point(front[i].first, front[i - 1].second);
    path += frame.point(front[i].first, front[i].second);
  }
  return "<polyline class='front' points='" + path + "'/>";
}

}  // namespace ar3d::report
