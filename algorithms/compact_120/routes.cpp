// Lemma D.10, and the drawing in space. The sites of the two ends and one byte per edge give the
// word and with it all five bends, so bends are computed when somebody reads them, in O(1).
#include "ar3d/algorithms/compact_120/routes.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "ar3d/algorithms/strips/routes.h"

namespace ar3d::compact_120 {
namespace {

/// @param code  the edge's arrival in two bits, then its variant.
void append_bends(unsigned code, const Point& at_tail, const Point& at_head,
                  std::vector<Point>& out) {
  const Quad tail = quad_of(site_of(at_tail));
  const Quad head = quad_of(site_of(at_head));
  const Shape shape{head[0] > tail[0], static_cast<Arrival>(code & 3), code >> 2};
  Route(shape, tail, head).append_bends(out);
}

std::vector<std::uint8_t> codes(const Graph& graph, const Strip& strip) {
  std::vector<std::uint8_t> code(graph.num_edges());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const Link& link : strip.links().at[v]) {
      if (!link.is_set() || link.is_out == 0) continue;
      const unsigned variant = strip.variant()[link.edge];
      code[link.edge] =  // first ends have smaller numbers
          strips::code_of(v > link.to, variant << 2 | link.at);
    }
  }
  return code;
}

}  // namespace

std::array<std::int64_t, 3> box_of(const StripSize& size) {
  const std::int64_t last = size.columns - 1;
  const std::int64_t across = 4 * last + 2;  // t is in 0 .. across
  const std::int64_t side = 3 * across / 2 + 4 * std::int64_t{size.rows} + size.beyond;
  return {side, side, 5 * across + 2};
}

Drawing lift(const Graph& graph, const Strip& strip) {
  const Vertex n = graph.num_vertices();
  Coordinates vertices(n, 20 * (std::int64_t{strip.size().columns} + strip.size().rows));
  for (Vertex v = 0; v < n; ++v) vertices.set(v, to_point(quad_of(strip.site(v))));
  return Drawing("compact-120", kCubeLattice, std::move(vertices), graph.shared_edges(),
                 std::make_shared<strips::CodedBends<append_bends>>(codes(graph, strip)));
}

}  // namespace ar3d::compact_120
