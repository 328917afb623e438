#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/analysis/report/frame.h"

namespace ar3d::report {

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

/// A point's mark at (x, y) by the largest number of bends per edge: 0 to 2, 3, 4, 5, more.
std::string bend_mark(std::size_t bends, double x, double y, const std::string& css);

/// "s3 d1": stroke and dash of a series colour; "f3": its fill.
std::string stroke_class(std::size_t colour);
std::string fill_class(std::size_t colour);

}  // namespace ar3d::report
