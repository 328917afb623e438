// Lemma C.6, and the drawing in space. The sites of the two ends and one byte per edge give the
// word and with it all five bends, so bends are computed when somebody reads them, in O(1).
#include "ar3d/algorithms/compact/routes.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "ar3d/algorithms/compact/words.h"
#include "ar3d/algorithms/strips/routes.h"

namespace ar3d::compact {
namespace {

/// @param code  whether the edge is red, and from bit 1 on its variant.
void append_bends(unsigned code, const Point& at_tail, const Point& at_head,
                  std::vector<Point>& out) {
  const Site tail = site_of(at_tail);
  const Site head = site_of(at_head);
  const Word word =
      word_of({(code & 1) != 0, tail.type, head.type, head.column > tail.column, code >> 1});
  const Letters from = letters_of(tail);
  append_bends_of(word, from, long_lengths(word, from, letters_of(head)), out);
}

std::vector<std::uint8_t> codes(const Graph& graph, const Decomposition& links,
                                const Placement& placement) {
  std::vector<std::uint8_t> code(graph.num_edges());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const Role role : {kGreenOut, kRedOut}) {
      const HalfEdge edge = links.at[v][role];
      if (edge.to == kNobody) continue;
      const unsigned variant = placement.variant[edge.edge];
      code[edge.edge] =  // first ends have smaller numbers
          strips::code_of(v > edge.to, variant << 1 | (is_red(role) ? 1u : 0u));
    }
  }
  return code;
}

}  // namespace

std::array<std::int64_t, 3> box_of(const StripSize& size) {
  // U stays within 4 of the vertices' range 0 .. 4 columns - 2, and V within span/2 + 2 of -2 .. 4
  // rows - 4. Green edges rise at most span + 6, red ones fall at most span + 4 (Lemma C.6).
  const std::int64_t span = 4 * std::int64_t{std::min(size.reach, size.columns - 1)} + 2;
  const std::int64_t side = 4 * (std::int64_t{size.columns} + size.rows) + span + 8;
  return {side, side, 2 * span + 10};
}

Drawing lift(const Graph& graph, const Decomposition& links, const Placement& placement) {
  const Vertex n = graph.num_vertices();
  Coordinates vertices(n, 4 * (std::int64_t{placement.size.columns} + placement.size.rows) + 4);
  for (Vertex v = 0; v < n; ++v) vertices.set(v, to_point(placement.places[v]));
  return Drawing(
      "compact", kCubeLattice, std::move(vertices), graph.shared_edges(),
      std::make_shared<strips::CodedBends<append_bends>>(codes(graph, links, placement)));
}

}  // namespace ar3d::compact
