#pragma once

#include <cstddef>
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

struct PlotOptions {
  bool points =
      false;  ///< points, band and fitted line (one family a plot) instead of medians alone
  TickStyle y_ticks = TickStyle::count;
};

/// A log-log plot against n as inline SVG, drawn for a width of 360 CSS pixels: medians per size;
/// with `points` also the instances (data-r = row), the band of the middle 80 % and the fitted
/// power law. The theorem's bound of the first series that has one is a dashed line. Empty string
/// if nothing is positive.
std::string scaling_svg(const std::vector<Series>& series, const std::string& title,
                        const PlotOptions& options);

/// Instances of one size that a plot shows: all of them, or this many spread evenly over the sorted
/// values.
inline constexpr std::size_t kPointsPerSize = 12;
std::vector<InstanceValue> shown_points(const SizeSample& size);

}  // namespace ar3d::report
