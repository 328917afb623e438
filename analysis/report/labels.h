#pragma once

#include <string>
#include <vector>

namespace ar3d::report {

/// A word beside a line or a point.
struct Label {
  double x = 0;
  double y = 0;
  std::string text;  ///< plain text; cut to `kLabelCharacters` with the whole as a title
  std::string css;   ///< classes of the <text>, such as the colour
};

inline constexpr std::size_t kLabelCharacters = 19;

/// The labels as SVG, moved up and down so that none stands on another one beside it, within
/// [top, bottom].
std::string labels_svg(std::vector<Label> labels, double top, double bottom);

}  // namespace ar3d::report
