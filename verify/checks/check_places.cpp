// Checks of single places: the lattice, the range of coordinates, the plane of the vertices, the
// box.
#include <fmt/format.h>

#include <vector>

#include "ar3d/verify/checks/checks.h"

namespace ar3d::verify {

void check_lattice(const Drawing& drawing, const Guarantee& guarantee, Findings& findings) {
  const Lattice& drawn = drawing.lattice();
  const Lattice& promised = guarantee.lattice;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      // Products of two 32-bit numbers.
      const std::int64_t left = std::int64_t{drawn.gram[i][j]} * promised.gram_denominator;
      const std::int64_t right = std::int64_t{promised.gram[i][j]} * drawn.gram_denominator;
      if (left == right) continue;
      findings.add({ViolationKind::lattice,
                    {},
                    {},
                    {},
                    fmt::format("gram[{}][{}] is {}/{}, the guarantee speaks of {}/{}", i, j,
                                drawn.gram[i][j], drawn.gram_denominator, promised.gram[i][j],
                                promised.gram_denominator)});
      return;
    }
  }
}

void check_coordinates(const Drawing& drawing, Findings& findings) {
  for (std::size_t i = 0; i < drawing.num_vertices(); ++i) {
    const auto v = static_cast<Vertex>(i);
    const Point p = drawing.vertex(v);
    if (in_range(p)) continue;
    findings.add({ViolationKind::coordinate_range,
                  {v},
                  {},
                  {p},
                  fmt::format("vertex {} at {}: a coordinate passes 2^61", v, to_string(p))});
  }
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (in_range(points[i])) continue;
      findings.add({ViolationKind::coordinate_range,
                    {},
                    {e},
                    {points[i]},
                    fmt::format("{}, bend {}: a coordinate passes 2^61", describe_edge(drawing, e),
                                to_string(points[i]))});
    }
  });
}

void check_plane(const Drawing& drawing, const Guarantee& guarantee, Findings& findings) {
  if (!guarantee.vertices_in_plane) return;
  for (std::size_t i = 0; i < drawing.num_vertices() && !findings.done(); ++i) {
    const auto v = static_cast<Vertex>(i);
    const Point p = drawing.vertex(v);
    if (p.z == 0) continue;
    findings.add({ViolationKind::plane,
                  {v},
                  {},
                  {p},
                  fmt::format("vertex {} at {} is not in the plane z = 0", v, to_string(p))});
  }
}

void check_size(const Graph& graph, const Box& box, const Guarantee& guarantee,
                Findings& findings) {
  const std::uint64_t n = graph.num_vertices();
  if (n == 0) return;  // bounds speak of n >= 1, and an empty drawing has no extents
  const auto extents = box.extents();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const AxisBound& bound = guarantee.bound.axes[axis];
    if (bound.holds(extents[axis], n)) continue;
    findings.add({ViolationKind::size,
                  {},
                  {},
                  {box.low, box.high},
                  fmt::format("the extent in {} is {}, more than {} for n = {}", "xyz"[axis],
                              extents[axis], bound.formula(), n)});
  }
}

}  // namespace ar3d::verify
