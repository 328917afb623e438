#pragma once

#include <limits>
#include <string>

#include "ar3d/analysis/report/axis.h"
#include "ar3d/analysis/scaling.h"

namespace ar3d::report {

/// Pixels of every plot: the viewBox and the rectangle of the data. Right of a labelled plot stand
/// the names of its lines.
inline constexpr double kWidth = 360, kHeight = 244, kLabelledWidth = 482;
inline constexpr double kLeft = 56, kRight = 350, kTop = 10, kBottom = 204;

/// Smallest and largest of what was included; NaN is ignored.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value);
  bool empty() const { return !(low <= high); }
};

/// Both logarithmic axes of a plot, with what their ticks count. Values are decimal logarithms.
struct Frame {
  LogAxis x;
  LogAxis y;
  TickStyle x_ticks = TickStyle::count;
  TickStyle y_ticks = TickStyle::count;
  std::string x_title = "vertices n";
  std::string y_title = {};
  std::string point(double log10_x, double log10_y) const;  ///< "x,y " in pixels
};

/// A frame over these ranges, its title above the data.
Frame frame_of(const Range& x, const Range& y, TickStyle y_ticks, const std::string& y_title);

/// Grid lines, tick labels and titles as SVG.
std::string axes_svg(const Frame& frame);

double decimal(double natural_log);
double log10_of(std::int64_t n);

}  // namespace ar3d::report
