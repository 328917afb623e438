#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/formats/drawings/edge_roles.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/guarantee.h"

namespace ar3d {

/// A broken promise as a page lists it.
struct PageViolation {
  std::string kind;
  std::string message;
  std::vector<Vertex> vertices;
  std::vector<EdgeId> edges;
  std::vector<Point> points;
};

/// Holds what a page says of a drawing beside showing it.
struct PageVerdict {
  const char* kind = "not judged";  ///< or "certified", or "violated"
  std::string text;                 ///< what was judged, or why nothing was
  std::vector<PageViolation> violations;
};

/// Most points (vertices and bends) of all the drawings of one page together.
inline constexpr std::uint64_t kMaxPagePoints = std::uint64_t{1} << 24;

/// Holds what every page has near its beginning.
inline constexpr const char* kViewerMark = "<meta name=\"generator\" content=\"ar3d viewer\">";

/// A drawing, or why there is none, as a page holds it.
struct PageEntry {
  std::string title;
  std::string about;          ///< JSON, without a '<'
  std::string geometry = {};  ///< edge_roles.h; empty: not drawn
  std::uint64_t points = 0;   ///< vertices and bends
  Point low = {};             ///< corner of the box, from which the geometry counts
};

/// `guarantee` gives the theorem's box; it may be missing. Safe on any thread.
/// @throws InputError "TITLE: …" if it has more than kMaxPagePoints points, or an extent passes
/// kMaxPageExtent.
PageEntry page_entry(const std::string& title, const Drawing& drawing, const Guarantee* guarantee,
                     const PageVerdict& verdict);
/// The same without the geometry, where its numbers come some other way (geometry_numbers).
PageEntry page_facts(const std::string& title, const Drawing& drawing, const EdgeRoles& roles,
                     const Guarantee* guarantee, const PageVerdict& verdict);
/// A graph that could not be drawn: the page says why in its place.
PageEntry page_entry(const std::string& title, std::uint64_t n, const std::string& error);

/// @throws InputError "TITLE: …" if those are more than kMaxPagePoints.
void require_page_points(std::uint64_t points, const std::string& title);

/// Returns the hashes of the scripts of such a page, as a content security policy names them: a page
/// that shows it in a frame has to allow them.
std::string viewer_script_hashes();

/// One HTML page that shows drawings in 3D, to be opened from disk without a network: geometry
/// (edge_roles.h), the viewer's scripts (viewer/) and three.js. It begins with its first
/// drawing, or with that of the attribute data-page of its body, from 0.
class ViewerPage {
 public:
  /// Writes the page's beginning. @param write  takes the page piece by piece; outlives it.
  explicit ViewerPage(std::function<void(std::string_view)> write);

  /// @throws InputError "TITLE: …" if the page would hold more than kMaxPagePoints points.
  void add(const PageEntry& entry);
  /// The page's end, with the scripts.
  void finish();

 private:
  std::function<void(std::string_view)> write_;
  std::size_t entries_ = 0;
  std::uint64_t points_ = 0;
};

}  // namespace ar3d
