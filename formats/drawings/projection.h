#pragma once

#include <string_view>
#include <vector>

#include "ar3d/formats/drawings/edge_roles.h"
#include "ar3d/formats/drawings/embedding.h"
#include "ar3d/model/drawing.h"

namespace ar3d {

/// Holds options of some formats. The camera of a picture turns about the z axis, then tilts
/// towards the viewer.
struct ExportOptions {
  double turn_degrees = 28;
  double tilt_degrees = 62;  ///< 0: from above, 90: from the side
  /// Distance of the eye from the middle of the box, in diagonals of the box; 0: orthographic.
  double perspective = 0;
  bool stretch = false;      ///< axes scaled so that the box is a cube: angles are not true then
  int longer_side = 900;     ///< units of the picture; the other side follows from the drawing
  double tube_radius = 0.2;  ///< of what is printed, in lattice units
};

/// A drawing on paper: straight strokes and balls, to be painted in their order. Where two segments
/// cross in the projection, the farther one has a gap.
struct Projection {
  struct PaintedItem {
    Real3 from;           ///< x and y, downwards
    Real3 to;             ///< of a ball: from
    int role = 0;         ///< of the stroke's edge; -1: a ball
    double depth = 0;     ///< larger is nearer
    double nearness = 0;  ///< 0 (farthest) to 1 (nearest)
    double scale = 1;     ///< of the perspective at the item; 1 if orthographic
    Vertex vertex = 0;    ///< of a ball
  };
  double width = 0;
  double height = 0;
  double stroke = 0;  ///< width of a stroke where scale is 1
  double ball = 0;    ///< radius of a ball there
  std::vector<PaintedItem> items;
};

/// @throws InputError "… holds at most …" naming the format if the drawing has more than 20,000
/// segments: the picture could not be read; or if the eye of a perspective would be in the drawing.
/// Cost: O(S^2) for S segments in the worst case; near-linear if few overlap from left to right.
Projection project(const Drawing& drawing, const ExportOptions& view, std::string_view format);

/// A colour faded towards white with distance.
Rgb faded(Rgb colour, double nearness);

}  // namespace ar3d
