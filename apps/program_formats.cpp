#include "program_formats.h"

#include "ar3d/formats/drawings/catalog.h"
#include "viewer_page.h"

namespace ar3d {

void register_program_formats() {
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
