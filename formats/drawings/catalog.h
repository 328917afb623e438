#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/drawings/projection.h"
#include "ar3d/model/drawing.h"

namespace ar3d {

/// A drawing, or a graph that could not be drawn, and where it comes from ("FILE:LINE").
struct PlacedLine {
  DrawingJsonlReader::Line line;
  std::string where;
};

/// The next drawing to be written; nothing at the end.
using NextDrawing = std::function<std::optional<PlacedLine>()>;

/// One row of the catalogue of drawing formats.
struct DrawingFormat {
  std::string name;
  std::vector<std::string> extensions;
  std::string summary;        ///< what is kept, and who reads it
  bool many_per_file = true;  ///< any number of drawings per file; else one
  /// Writes the drawings to a file ("-": standard output).
  /// @throws InputError if it cannot be written, or if there is not exactly one drawing and the
  /// format holds one per file.
  std::function<void(const NextDrawing&, const std::string& path, const ExportOptions&)> write;
};

/// All formats of drawings.
const std::vector<DrawingFormat>& drawing_formats();

/// Adds a row to the catalogue: before anything else uses it, by one thread. References to other
/// rows stay valid. @throws InputError if the name is taken or empty, or there is no writer.
void register_drawing_format(DrawingFormat row);

/// A line for each format: its name, its endings, what it keeps.
std::string drawing_formats_text();

/// Writes one drawing; `where` names it in messages.
void write_drawing(const DrawingFormat& format, Drawing drawing, const std::string& where,
                   const std::string& path, const ExportOptions& options = {});

/// The format called `name`, or, if that is empty, the one whose ending the path has; JSON lines
/// where the path has no ending and for standard output.
/// @throws InputError naming the unknown format or the ending that is none's.
const DrawingFormat& drawing_format(std::string_view name, const std::string& path);

}  // namespace ar3d
