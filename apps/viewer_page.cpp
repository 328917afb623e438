// Pages that show drawings in 3D and judge what they show: a format of drawings for program and
// Python package.

#include <string>
#include <string_view>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/formats/text/output.h"
#include "batches.h"
#include "view.h"

namespace ar3d {
std::uint64_t weight_of(const DrawingJsonlReader::Line& line) {
  const auto* drawing = std::get_if<Drawing>(&line);
  return drawing == nullptr ? 0 : std::uint64_t{drawing->num_vertices()} + drawing->num_edges();
}

void write_viewer_page(const NextDrawing& next, const std::string& path,
                       const std::string& algorithm) {
  OutputFile file(path);
  ViewerPage page([&](std::string_view text) { file.append(text); });
  bool is_empty = true;
  const auto entry_of = [&](const PlacedLine& placed) {
    if (const auto* undrawn = std::get_if<UndrawnGraph>(&placed.line)) {
      return page_entry(placed.where, undrawn->n, undrawn->error);
    }
    const auto& drawing = std::get<Drawing>(placed.line);
    const Algorithm* const known =
        algorithm.empty() ? known_algorithm(drawing.algorithm()) : &find_algorithm(algorithm);
    return page_entry(placed.where, drawing, known == nullptr ? nullptr : &known->guarantee,
                      page_verdict(drawing, known));
  };
  in_batches<PlacedLine>(
      next, [](const PlacedLine& placed) { return weight_of(placed.line); }, entry_of,
      [&](const PageEntry& entry) {
        is_empty = false;
        page.add(entry);
      });
  if (is_empty) throw InputError("the input has no graph");
  page.finish();
  file.commit();
}

void register_program_formats() {
  register_drawing_format(
      {"html",
       {".html", ".htm"},
       "a page that shows drawings in 3D, exact coordinates included; any number per file",
       true,
       [](const NextDrawing& next, const std::string& path, const ExportOptions&) {
         write_viewer_page(next, path);
       }});
}

}  // namespace ar3d
