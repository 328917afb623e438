#include "ar3d/analysis/report/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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

}  // namespace ar3d::report
