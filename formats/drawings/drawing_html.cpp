// The page of drawings: their data as JSON and packed texts, then the viewer, all in one file that
// opens from disk.
#include "ar3d/formats/drawings/drawing_html.h"

#include <fmt/format.h>

#include "ar3d_viewer.h"

namespace ar3d {
namespace {

using Sink = std::function<void(std::string_view)>;

void append_parts(const Sink& write, const auto& parts) {
  for (const std::string_view part : parts) write(part);
}

}  // namespace

PageEntry page_entry(const std::string& title, const Drawing& drawing, const Guarantee* guarantee,
                     const PageVerdict& verdict) {
  const EdgeRoles roles = edge_roles(drawing);
  PageEntry entry = page_facts(title, drawing, roles, guarantee, verdict);
  entry.geometry = packed_geometry(drawing, roles, entry.low);
  return entry;
}

std::string viewer_script_hashes() {
  return fmt::format("{} {}", kViewerThreeHash, kViewerScriptHash);
}

ViewerPage::ViewerPage(Sink write) : write_(std::move(write)) {
  write_("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
  write_(kViewerMark);
  write_(
      fmt::format("\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                  "style-src 'unsafe-inline'; script-src {}; img-src data: blob:\">\n",
                  viewer_script_hashes()));
  write_(
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>ar3d: drawings in 3D</title>\n<style>\n");
  append_parts(write_, kViewerStyle);
  write_("</style>\n</head>\n<body>\n");
  append_parts(write_, kViewerBody);
}

void ViewerPage::add(const PageEntry& entry) {
  points_ += entry.points;
  require_page_points(points_, entry.title);
  write_(fmt::format("<script type=\"application/json\" id=\"about-{}\">", entries_));
  write_(entry.about);
  write_("</script>\n");
  if (!entry.geometry.empty()) {
    write_(fmt::format("<script type=\"text/plain\" id=\"geometry-{}\">", entries_));
    write_(entry.geometry);
    write_("</script>\n");
  }
  ++entries_;
}

void ViewerPage::finish() {
  write_("<script>\n");
  append_parts(write_, kViewerThree);
  write_("</script>\n<script>\n");
  append_parts(write_, kViewerScript);
  write_("</script>\n</body>\n</html>\n");
}

}  // namespace ar3d
