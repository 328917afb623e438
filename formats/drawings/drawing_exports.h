#pragma once

#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/formats/drawings/edge_roles.h"
#include "ar3d/formats/drawings/embedding.h"
#include "ar3d/formats/drawings/projection.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/model/drawing.h"

// Drawings for other programs. Unless said otherwise points are in space (embedding.h): one unit is
// the lattice's unit of length, z is up; vertices come first, in the order of their numbers, then
// the bends in the order of the edges, each from u to v. Colours are those of the edges' roles
// (edge_roles.h). Each takes O(n + bends) time and throws InputError "FORMAT holds at most …" for a
// drawing that is too large.

namespace ar3d {

/// Most vertices and bends of an exported drawing.
inline constexpr std::uint64_t kMaxExportPoints = std::uint64_t{1} << 24;

/// VTK PolyData as XML: points with the number of the vertex (-1: a bend) and exact lattice
/// coordinates, cells with the number of the edge (-1: a vertex), role and colour.
void write_vtp(OutputFile& output, const Drawing& drawing);

/// glTF 2.0, binary: points for the vertices, lines for the edges of each role with its colour as
/// unlit material; attributes _VERTEX and _EDGE hold numbers, -1 where there is none. Coordinates
/// are rounded to 32 bits after the low corner has been taken off (extras.low); a rotation makes y
/// the upward axis.
/// @throws InputError also if an extent passes 2^24, where 32 bits end to tell units apart.
void write_glb(OutputFile& output, const Drawing& drawing);

/// STL, binary, for 3D printing: each edge a closed tube with mitred bends, each vertex a closed
/// ball; a slicer unites them. The low corner of the box is the origin.
/// @param radius  of the tubes in units; balls have 2.2 times that.
/// @throws InputError also if an extent passes 2^16, an edge has a segment of length 0
/// or turns back, or a segment is too short for the bends at its ends.
void write_stl(OutputFile& output, const Drawing& drawing, double radius);

/// GraphML: nodes n0, n1, … with exact lattice coordinates x, y, z, edges e0, e1, … with role and
/// bends "x y z;x y z"; the Gram matrix and the algorithm at the graph.
void write_graphml(OutputFile& output, const Drawing& drawing);

// What the writers share.

/// Foreign text as text of XML.
inline std::string xml_text(std::string_view text) {
  std::string out = printable(text);
  boost::algorithm::replace_all(out, "&", "&amp;");
  boost::algorithm::replace_all(out, "<", "&lt;");
  boost::algorithm::replace_all(out, ">", "&gt;");
  return out;
}

/// @return the number of vertices and bends. @throws InputError if it passes kMaxExportPoints.
inline std::uint64_t count_export_points(const Drawing& drawing, std::string_view format) {
  const std::uint64_t count = drawing.num_vertices() + count_bends(drawing);
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

inline constexpr Rgb kVertexColour = {44, 49, 57};

/// A picture of a small drawing as an SVG document: edges as strokes in the colours of their roles
/// (edge_roles.h), paler with distance, with gaps where they pass behind others; vertices as balls.
/// Angles are true in space: the lattice's metric is embedded before projecting. Each element has
/// the class of what it shows, so that a style sheet can change it.
/// @throws InputError as project().
std::string drawing_to_svg(const Drawing& drawing, const ExportOptions& view = {});

/// The same picture as a tikzpicture, for \input in a document that loads TikZ; sizes in points,
/// colours named ar3drole0, ar3drole1, …
/// @throws InputError as project().
std::string drawing_to_tikz(const Drawing& drawing, const ExportOptions& view = {});

}  // namespace ar3d
