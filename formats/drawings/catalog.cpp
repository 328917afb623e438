// The table of drawing formats. Pages need more than formats/ may include: the program adds them.
#include "ar3d/formats/drawings/catalog.h"

#include "ar3d/base/open_table.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/drawing_exports.h"

namespace ar3d {
namespace {

/// The only drawing. @throws InputError if there is none, or another one.
Drawing only_drawing(const NextDrawing& next, std::string_view format) {
  std::optional<PlacedLine> first = next();
  if (!first) throw InputError("the input has no graph");
  if (const auto* undrawn = std::get_if<UndrawnGraph>(&first->line)) {
    throw InputError(fmt::format("{}: {}", first->where, undrawn->error));
  }
  if (const std::optional<PlacedLine> second = next()) {
    throw InputError(fmt::format("{}: a second graph, but format {} holds one drawing per file",
                                 second->where, format));
  }
  return std::get<Drawing>(std::move(first->line));
}

void write_jsonl(const NextDrawing& next, const std::string& path, const ExportOptions&) {
  OutputFile file(path);
  while (const std::optional<PlacedLine> placed = next()) {
    if (const auto* drawing = std::get_if<Drawing>(&placed->line)) {
      write_drawing_line(file, *drawing);
    } else {
      append_error_line(file.pending(), std::get<UndrawnGraph>(placed->line));
    }
  }
  file.commit();
}

/// A format that holds one drawing per file. @param make  writes it, or returns its text.
template <class Make>
DrawingFormat one_drawing(std::string name, std::vector<std::string> extensions,
                          std::string summary, Make make) {
  const auto write = [name, make](const NextDrawing& next, const std::string& path,
                                  const ExportOptions& options) {
    const Drawing drawing = only_drawing(next, name);
    OutputFile file(path);
    if constexpr (std::is_invocable_v<Make, const Drawing&, const ExportOptions&>) {
      file.append(make(drawing, options));
    } else if constexpr (std::is_invocable_v<Make, OutputFile&, const Drawing&>) {
      make(file, drawing);
    } else {
      make(file, drawing, options);
    }
    file.commit();
  };
  return {std::move(name), std::move(extensions), std::move(summary), false, write};
}

std::vector<DrawingFormat> catalogue() {
  return {
      {"jsonl",
       {".jsonl", ".json", ".ndjson"},
       "exact: positions, bends and metric, one JSON line per drawing; read by verify",
       true,
       write_jsonl},
      one_drawing(
          "svg", {".svg"},
          "a picture of a small drawing: roles as colours, gaps where edges pass behind others",
          drawing_to_svg),
      one_drawing("tikz", {".tex", ".tikz"}, "the same picture for LaTeX: roles as named colours",
                  drawing_to_tikz),
      one_drawing(
          "vtp", {".vtp"},
          "VTK, for ParaView: numbers, roles, colours, exact lattice coordinates; lattice units",
          write_vtp),
      one_drawing("glb", {".glb"},
                  "glTF 2.0: numbers as attributes, roles as materials; coordinates of 32 bits, "
                  "lattice units as metres",
                  write_glb),
      one_drawing("stl", {".stl"},
                  "closed tubes and balls for 3D printing; no numbers, no colours; lattice units "
                  "as millimetres; --tube",
                  [](OutputFile& file, const Drawing& drawing, const ExportOptions& options) {
                    write_stl(file, drawing, options.tube_radius);
                  }),
      one_drawing(
          "graphml", {".graphml"},
          "the graph with exact lattice coordinates, bends and roles as attributes, and the metric",
          write_graphml),
  };
}

OpenTable<DrawingFormat>& table() {
  static OpenTable<DrawingFormat> rows(
      "drawing format", catalogue(), [](const DrawingFormat& row) { return row.write != nullptr; });
  return rows;
}

}  // namespace

const std::vector<DrawingFormat>& drawing_formats() { return table().rows(); }

void register_drawing_format(DrawingFormat row) { table().add(std::move(row)); }

std::string drawing_formats_text() {
  std::string text = "Formats of drawings, by --format or by the file's ending:\n";
  for (const DrawingFormat& format : drawing_formats()) {
    text += fmt::format("  {:<8} {}: {}\n", format.name, fmt::join(format.extensions, " "),
                        format.summary);
  }
  return text;
}

void write_drawing(const DrawingFormat& format, Drawing drawing, const std::string& where,
                   const std::string& path, const ExportOptions& options) {
  std::optional<PlacedLine> only = PlacedLine{std::move(drawing), where};
  format.write([&] { return std::exchange(only, std::nullopt); }, path, options);
}

const DrawingFormat& drawing_format(std::string_view name, const std::string& path) {
  if (!name.empty()) return format_called(name, drawing_formats(), "drawing");
  const std::string ending = path == "-" ? "" : path_ending(path);
  if (ending.empty()) return drawing_formats().front();
  return format_of_ending(ending, path, drawing_formats(), "drawing");
}

}  // namespace ar3d
