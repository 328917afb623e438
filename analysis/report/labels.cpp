#include "ar3d/analysis/report/labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ar3d/analysis/report/html.h"

namespace ar3d::report {
namespace {

constexpr double kLine = 11.5;  // between two labels
constexpr double kReach = 100;  // labels further apart than this do not touch

/// The first characters (not bytes) of UTF-8 text.
std::string cut(const std::string& text) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_start = (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80;
    if (is_start && ++characters > kLabelCharacters) return text.substr(0, i) + "…";
  }
  return text;
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
  std::string svg;
  for (const Label& label : labels) {
    svg += fmt::format("<text class='{}' x='{:.1f}' y='{:.1f}'>{}<title>{}</title></text>",
                       label.css, label.x, label.y, escape(cut(label.text)), escape(label.text));
  }
  return svg;
}

}  // namespace ar3d::report
