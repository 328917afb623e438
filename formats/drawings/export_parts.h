#pragma once

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/formats/drawings/drawing_exports.h"
#include "ar3d/formats/drawings/edge_roles.h"
#include "ar3d/formats/drawings/embedding.h"

namespace ar3d {

/// @return the number of vertices and bends. @throws InputError if it passes kMaxExportPoints.
inline std::uint64_t count_export_points(const Drawing& drawing, std::string_view format) {
  std::uint64_t count = drawing.num_vertices();
  for_each_polyline(drawing,
                    [&](EdgeId, const std::vector<Point>& points) { count += points.size() - 2; });
  if (count > kMaxExportPoints) {
    throw InputError(
        fmt::format("{} vertices and bends, {} holds at most {}", count, format, kMaxExportPoints));
  }
  return count;
}

/// @throws InputError if an extent passes `most`.
inline void refuse_larger_extents(const Drawing& drawing, std::int64_t most,
                                  std::string_view format) {
  for (const std::int64_t extent : bounding_box(drawing).extents()) {
    if (extent <= most) continue;
    throw InputError(fmt::format("an extent of {}, {} holds at most {}", extent, format, most));
  }
}

/// Calls visit(p) for every vertex, then for every bend, in the order of drawing_exports.h.
template <class Visit>
void for_each_export_point(const Drawing& drawing, Visit&& visit) {
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    visit(drawing.vertex(static_cast<Vertex>(v)));
  }
  for_each_polyline(drawing, [&](EdgeId, const std::vector<Point>& points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) visit(points[i]);
  });
}

/// Calls visit(e, numbers) with the numbers of the points of edge e from u to v.
template <class Visit>
void for_each_numbered_polyline(const Drawing& drawing, Visit&& visit) {
  std::uint64_t next = drawing.num_vertices();
  std::vector<std::uint64_t> numbers;
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    numbers.assign(1, drawing.edge(e).u);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) numbers.push_back(next++);
    numbers.push_back(drawing.edge(e).v);
    visit(e, numbers);
  });
}

/// The colour of an edge.
inline Rgb colour_of(const EdgeRoles& roles, EdgeId e) {
  return roles.roles[roles.edges[e]].colour;
}

inline constexpr Rgb kVertexColour = {44, 49, 57};

}  // namespace ar3d
