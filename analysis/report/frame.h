#pragma once

#include <limits>
#include <string>
#include <vector>

#include "ar3d/analysis/report/axis.h"
#include "ar3d/analysis/scaling.h"

namespace ar3d::report {

/// One curve of a plot.
struct Series {
  std::string label;  ///< plain text; escaped when written
  const ScalingEntry* entry = nullptr;
  std::size_t colour = 0;
};

/// Pixels of every plot: the viewBox and the rectangle of the data.
inline constexpr double kWidth = 360, kHeight = 244;
inline constexpr double kLeft = 56, kRight = 350, kTop = 10, kBottom = 204;

/// Smallest and largest of what was included; NaN is ignored.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value);
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

/// The frame that everything of these curves fits: sizes, instances and the theorem's bound.
Frame frame_of(const std::vector<Series>& series, TickStyle y_ticks);

/// Grid lines, tick labels and titles as SVG.
std::string axes_svg(const Frame& frame);

double decimal(double natural_log);
double log10_n(const SizeSample& size);

}  // namespace ar3d::report
