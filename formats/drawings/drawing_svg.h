#pragma once

#include <string>

#include "ar3d/formats/drawings/projection.h"
#include "ar3d/model/drawing.h"

namespace ar3d {

/// A picture of a small drawing as an SVG document: edges as strokes in the colours of their roles
/// (edge_roles.h), paler with distance, with gaps where they pass behind others; vertices as balls.
/// Angles are true in space: the lattice's metric is embedded before projecting. Each element has
/// the class of what it shows, so that a style sheet can change it.
/// @throws InputError as project().
std::string drawing_to_svg(const Drawing& drawing, const ExportOptions& view = {});

/// The same picture as a tikzpicture, for \input in a document that loads TikZ; sizes in points,
/// colours named ar3drole0, ar3drole1, …
/// @throws InputError as project().
std::string drawing_to_tikz(const Drawing& drawing, const ExportOptions& view = {});

}  // namespace ar3d
