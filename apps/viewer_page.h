#pragma once

#include <string>

#include "drawing_formats.h"

namespace ar3d {

/// Writes an HTML page that shows the drawings, each judged on the graph that it draws against the
/// guarantee of `algorithm`, or, if that is empty, of the algorithm that the drawing names.
/// @throws InputError if it cannot be written, or the drawings are too large for a page.
void write_viewer_page(const NextDrawing& next, const std::string& path,
                       const std::string& algorithm = {});

}  // namespace ar3d
