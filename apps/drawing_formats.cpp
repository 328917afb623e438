#include "drawing_formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/model/error.h"
#include "ar3d/model/nearest_name.h"
#include "ar3d/results/hdf5/drawing_hdf5.h"
#include "viewer_page.h"

namespace ar3d {
namespace {

using Writer = std::function<void(const NextDrawing&, const std::string&, const SvgView&)>;

/// The only drawing. @throws InputError if there is none, or another one.
Drawing only_drawing(const NextDrawing& next, std::string_view format) {
  std::optional<PlacedLine> first = next();
  if (!first) throw InputError("the input has no graph");
  if (const auto* undrawn = std::get_if<UndrawnGraph>(&first->line)) {
    throw InputError(fmt::format("{}: {}", first->where, undrawn->error));
  }
  if (const std::optional<PlacedLine> second = next()) {
    throw InputError(fmt::format("{}: a second graph, but format {} holds one drawing a file",
                                 second->where, format));
  }
  return std::get<Drawing>(std::move(first->line));
}

/// A writer of files that hold one drawing.
template <class WriteOne>
Writer one_drawing(std::string_view format, WriteOne write) {
  return [format, write](const NextDrawing& next, const std::string& path, const SvgView& view) {
    write(only_drawing(next, format), path, view);
  };
}

void write_jsonl(const NextDrawing& next, const std::string& path, const SvgView&) {
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

void write_svg(const Drawing& drawing, const std::string& path, const SvgView& view) {
  OutputFile file(path);
  file.append(drawing_to_svg(drawing, view));
  file.commit();
}

const DrawingFormat& format_of_path(const std::string& path) {
  const std::string ending = path_ending(path);
  if (ending.empty()) return drawing_formats().front();
  std::vector<std::string> known;
  for (const DrawingFormat& format : drawing_formats()) {
    for (const std::string& extension : format.extensions) {
      if (extension == ending) return format;
      known.push_back(extension);
    }
  }
  throw InputError(
      fmt::format("{}: '{}' is no drawing format's ending (known: {}); --format says "
                  "which one is meant",
                  path, ending, fmt::join(known, " ")));
}

}  // namespace

const std::vector<DrawingFormat>& drawing_formats() {
  static const std::vector<DrawingFormat> rows = {
      {"jsonl",
       {".jsonl", ".json", ".ndjson"},
       "exact: positions, bends and metric, one JSON line per drawing; read by verify",
       true,
       write_jsonl,
       true},
      {"hdf5",
       {".h5", ".hdf5"},
       "exact: positions, bends and metric as arrays, for h5py; one drawing per file",
       false,
       one_drawing("hdf5", [](const Drawing& drawing, const std::string& path,
                              const SvgView&) { write_drawing_hdf5(drawing, path); }),
       false},
      {"svg",
       {".svg"},
       "a picture of a small drawing, rounded; one drawing per file",
       false,
       one_drawing("svg", write_svg),
       true},
      {"html",
       {".html", ".htm"},
       "a page that shows drawings in 3D, exact coordinates included; any number per file",
       true,
       [](const NextDrawing& next, const std::string& path, const SvgView&) {
         write_viewer_page(next, path);
       },
       true},
  };
  return rows;
}

std::string drawing_formats_text() {
  std::string text = "Formats of drawings, by --format or by the file's ending:\n";
  for (const DrawingFormat& format : drawing_formats()) {
    text += fmt::format("  {:<8} {}: {}\n", format.name, fmt::join(format.extensions, " "),
                        format.summary);
  }
  return text;
}

void write_drawing(const DrawingFormat& format, Drawing drawing, const std::string& where,
                   const std::string& path, const SvgView& view) {
  std::optional<PlacedLine> only = PlacedLine{std::move(drawing), where};
  format.write([&] { return std::exchange(only, std::nullopt); }, path, view);
}

const DrawingFormat& drawing_format(std::string_view name, const std::string& path) {
  if (name.empty()) return path == "-" ? drawing_formats().front() : format_of_path(path);
  for (const DrawingFormat& format : drawing_formats()) {
    if (format.name != name) continue;
    if (path == "-" && !format.to_stream) {
      throw InputError(
          fmt::format("format {} cannot go to standard output: give a file with -o", name));
    }
    return format;
  }
  const auto known = names_of(drawing_formats());
  throw InputError(fmt::format("unknown drawing format '{}', known: {}{}", name,
                               fmt::join(known, ", "), did_you_mean(name, known)));
}

}  // namespace ar3d
