#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/analysis/scaling.h"

namespace ar3d::report {

/// What the ticks of a logarithmic axis count.
enum class TickStyle {
  count,    ///< 200, 1k, 10k, 1M
  power,    ///< 10⁶, 10⁹
  seconds,  ///< 10 µs, 1 ms, 1 s
  share,    ///< 0 %, 25 %, 100 % of an axis that is linear from 0 to 1
};

struct Tick {
  double log10 = 0;
  std::string label;  ///< empty: a minor tick
};

/// A logarithmic axis from data to pixels. Values are decimal logarithms throughout.
class LogAxis {
 public:
  /// Covers [low, high] with a little air; a range of no width is opened to half a decade either
  /// way.
  LogAxis(double low, double high, double first_pixel, double last_pixel);

  double pixel(double log10) const;
  double low() const { return low_; }
  double high() const { return high_; }
  /// At most about `most` labelled ticks: decades (every k-th if there are many), else 1-2-5 within
  /// a decade, else numbers of two digits.
  std::vector<Tick> ticks(TickStyle style, int most) const;

 private:
  /// Numbers of two digits; none if they would be more than `most`.
  std::vector<Tick> narrow_ticks(TickStyle style, int most) const;

  double low_;
  double high_;
  double first_pixel_;
  double last_pixel_;
};

/// Pixels of every plot: the viewBox and the rectangle of the data. Right of a labelled plot stand
/// the names of its lines.
inline constexpr double kWidth = 360, kHeight = 244, kLabelledWidth = 482;
inline constexpr double kLeft = 56, kRight = 350, kTop = 10, kBottom = 204;

/// Smallest and largest of what was included; NaN is ignored.
struct LogRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value);
  bool empty() const { return !(low <= high); }
};

/// Both logarithmic axes of a plot, with what their ticks count. Values are decimal logarithms.
struct PlotFrame {
  LogAxis x;
  LogAxis y;
  TickStyle x_ticks = TickStyle::count;
  TickStyle y_ticks = TickStyle::count;
  std::string x_title = "vertices n";
  std::string y_title = {};
  std::string point(double log10_x, double log10_y) const;  ///< "x,y " in pixels
};

/// A frame over these ranges, its title above the data.
PlotFrame frame_of(const LogRange& x, const LogRange& y, TickStyle y_ticks,
                   const std::string& y_title);

/// Grid lines, tick labels and titles as SVG.
std::string axes_svg(const PlotFrame& frame);

double decimal(double natural_log);
double log10_of(std::int64_t n);

/// Bend histogram: the share of edges with 0, 1, … bends. Empty string without edges.
std::string bend_svg(const std::array<std::uint64_t, 8>& bends);

/// <svg> of a plot as it stands in the page.
std::string svg_element(const std::string& title, double width, double height,
                        const std::string& content);

/// A path of dots that the page's script can point at: "x y" pixels and a row each.
struct Dots {
  std::string path;
  std::string rows;
  void add(double x, double y, std::size_t row);
  std::string svg(const std::string& css) const;  ///< empty if there are none
};

/// `most` graphs of one size, evenly over the sorted values, the least and the largest among them;
/// all of them if they are no more.
std::vector<InstanceValue> shown_points(const SizeSample& size, std::size_t most);

/// A point's mark at (x, y) by the largest number of bends per edge: 0, 1 or 2, 3, 4, 5, more.
std::string bend_mark(std::size_t bends, double x, double y, const std::string& css);

/// "s3 d1": stroke and dash of a series colour; "f3": its fill.
std::string stroke_class(std::size_t colour);
std::string fill_class(std::size_t colour);

/// A word beside a line or a point.
struct Label {
  double x = 0;
  double y = 0;
  std::string text;  ///< plain text; cut to kLabelCharacters where that tells the labels apart
  std::string css;   ///< classes of the <text>, such as the colour
};

inline constexpr std::size_t kLabelCharacters = 19;

/// The labels as SVG, moved up and down so that none stands on another one beside it, within
/// [top, bottom].
std::string labels_svg(std::vector<Label> labels, double top, double bottom);

/// <svg> of a plot with names right of its lines. @param top  of the names.
std::string labelled_svg(const std::string& title, const std::string& content,
                         std::vector<Label> labels, double top = kTop + 8);

/// The x and y of a front as steps: no other point is smaller in both.
std::vector<std::pair<double, double>> front_of(std::vector<std::pair<double, double>> points);
/// Their line, with the steps between them.
std::string front_svg(const std::vector<std::pair<double, double>>& front, const PlotFrame& frame);

/// Sizes that stand together.
struct SizeBin {
  std::int64_t first = 0, last = 0;
  std::string text() const;  ///< "1,000", "100 – 199"
};
/// One bin a size if there are at most `most`; else those of `most` equal parts of the logarithmic
/// scale that hold any. @param sizes  at least 1 each; smaller ones are in no bin but the first.
std::vector<SizeBin> size_bins(const std::set<std::int64_t>& sizes, std::size_t most);

/// At most `most` of the items, evenly, the first and the last among them.
template <class Item>
std::vector<Item> evenly(const std::vector<Item>& items, std::size_t most) {
  if (items.size() <= most) return items;
  if (most < 2) return {items.back()};
  std::vector<Item> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(items[i * (items.size() - 1) / (most - 1)]);
  return kept;
}

}  // namespace ar3d::report
