#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ar3d/analysis/report/frame.h"

namespace ar3d::report {

struct PlotOptions {
  bool points =
      false;  ///< points, band and fitted line (one family a plot) instead of medians alone
  std::string axes = {};  ///< what stands for the axes, such as a <use>; empty: axes_svg(frame)
};

/// A log-log plot against n as SVG of kWidth x kHeight CSS pixels: medians per size; with `points`
/// also the instances, the band of the middle 80 %, the fitted power law, and at the upper edge the
/// rows that were cut off. The theorem's bound of the first series that has one is a dashed line.
std::string scaling_svg(const std::vector<Series>& series, const std::string& title,
                        const Frame& frame, const PlotOptions& options);

/// The residuals of the series' power law, as factors by size: mean and middle 80 %; sizes that the
/// fit left out are grey. Empty if nothing was fitted.
std::string residual_svg(const Series& series, const std::string& title, const Frame& frame);

/// Bend histogram: the share of edges with 0, 1, … bends. Empty string without edges.
std::string bend_svg(const std::array<std::uint64_t, 8>& bends);

/// <svg> of a plot as it stands in the page.
std::string svg_element(const std::string& title, double height, const std::string& content);

/// A path of dots that the page's script can point at: "x y" pixels and a row each.
struct Dots {
  std::string path;
  std::string rows;
  void add(double x, double y, std::size_t row);
  std::string svg(const std::string& css) const;  ///< empty if there are none
};

/// Instances of one size that a plot shows: all of them, or this many spread evenly over the sorted
/// values.
inline constexpr std::size_t kPointsPerSize = 12;
std::vector<InstanceValue> shown_points(const SizeSample& size);

/// "s3 d1": stroke and dash of a series colour.
std::string stroke_class(std::size_t colour);

}  // namespace ar3d::report
