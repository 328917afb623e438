#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/formats/drawings/drawing_svg.h"
#include "ar3d/model/drawing.h"

namespace ar3d {

/// One row of the catalogue of drawing formats.
struct DrawingFormat {
  std::string name;
  std::vector<std::string> extensions;
  std::string summary;        ///< what is kept, and who reads it
  bool many_per_file = true;  ///< one line per drawing; else one drawing per file
  /// Writes one drawing to a file ("-": standard output, if `to_stream`).
  /// @throws InputError if it cannot be written.
  std::function<void(const Drawing&, const std::string& path, const SvgView&)> write;
  bool to_stream = true;  ///< can go to standard output
};

const std::vector<DrawingFormat>& drawing_formats();

/// The format called `name`, or, if that is empty, the one whose ending the path has; JSON lines
/// where the path has no ending and for standard output.
/// @throws InputError naming the unknown format or the ending that is none's, or if the format
/// cannot go to standard output.
const DrawingFormat& drawing_format(std::string_view name, const std::string& path);

}  // namespace ar3d
