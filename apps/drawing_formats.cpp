#include "drawing_formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/model/error.h"
#include "ar3d/model/nearest_name.h"
#include "ar3d/results/hdf5/drawing_hdf5.h"

namespace ar3d {
namespace {

void write_jsonl(const Drawing& drawing, const std::string& path, const SvgView&) {
  OutputFile file(path);
  write_drawing_line(file, drawing);
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
       [](const Drawing& drawing, const std::string& path, const SvgView&) {
         write_drawing_hdf5(drawing, path);
       },
       false},
      {"svg",
       {".svg"},
       "a picture of a small drawing, rounded; one drawing per file",
       false,
       write_svg,
       true},
  };
  return rows;
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
