// Differences of successive points as integers of 7 bits a byte.
#include "ar3d/formats/drawings/edge_roles.h"

namespace ar3d {

std::string geometry_numbers(const Drawing& drawing, const EdgeRoles& roles, Point low) {
  std::string out;
  const auto add = [&](std::uint64_t value) {
    for (; value >= 128; value >>= 7) out.push_back(static_cast<char>(value | 128));
    out.push_back(static_cast<char>(value));
  };
  const auto add_signed = [&](std::int64_t value) {
    add(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
  };
  const auto add_vector = [&](Vector d) {
    add_signed(d.x);
    add_signed(d.y);
    add_signed(d.z);
  };
  Point last = low;
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    const Point p = drawing.vertex(static_cast<Vertex>(v));
    add_vector(p - last);
    last = p;
  }
  std::int64_t last_u = 0;
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    const Edge ends = drawing.edge(e);
    add_signed(std::int64_t{ends.u} - last_u);
    last_u = ends.u;
    add_signed(std::int64_t{ends.v} - last_u);
    add(points.size() - 2);
    add(roles.edges[e]);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) add_vector(points[i] - points[i - 1]);
  });
  return out;
}

}  // namespace ar3d
