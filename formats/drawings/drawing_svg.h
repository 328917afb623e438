#pragma once

#include <string>

#include "ar3d/model/drawing.h"

namespace ar3d {

/// The camera of a picture: turn about the z axis, then tilt towards the viewer; orthographic.
struct SvgView {
  double turn_degrees = 28;
  double tilt_degrees = 62;  ///< 0: from above, 90: from the side
  int longer_side = 900;     ///< pixels; the other side follows from the drawing
};

/// A picture of a small drawing as an SVG document: edges as shaded tubes (properly edge-coloured,
/// nearer ones in front), vertices as balls. Angles are true in space: the lattice's metric is
/// embedded before projecting.
/// @throws InputError if the drawing has more than 20000 segments: nobody could read the picture.
/// Cost: O(S log S) for S segments.
std::string drawing_to_svg(const Drawing& drawing, const SvgView& view = {});

}  // namespace ar3d
