#include "program_formats.h"

#include "ar3d/base/error.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/store/hdf5/drawing_hdf5.h"
#include "viewer_page.h"

namespace ar3d {
namespace {

void write_hdf5(const Drawing& drawing, const std::string& path, const ExportOptions&) {
  if (drawing.real) {
    throw InputError(path + ": a drawing in a real type is written as jsonl (exact) or svg");
  }
  write_drawing_hdf5(drawing, path);
}

}  // namespace

void register_program_formats() {
  register_drawing_format(
      {"hdf5",
       {".h5", ".hdf5"},
       "exact: positions, bends and metric as arrays, for h5py; one drawing per file",
       false,
       one_drawing_per_file("hdf5", write_hdf5),
       false});
  register_drawing_format(
      {"html",
       {".html", ".htm"},
       "a page that shows drawings in 3D, exact coordinates included; any number per file",
       true,
       [](const NextDrawing& next, const std::string& path, const ExportOptions&) {
         write_viewer_page(next, path);
       },
       true});
}

}  // namespace ar3d
