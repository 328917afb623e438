// Lemma C.6, and the drawing in space. The sites of the two ends and one byte per edge give the
// word and with it all five bends, so bends are computed when somebody reads them, in O(1).
#include "ar3d/algorithms/compact/routes.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "ar3d/model/error.h"

namespace ar3d::compact {
namespace {

constexpr unsigned kRedBit = 1;
constexpr unsigned kBackwardBit = 2;  ///< the tail is the edge's second end
constexpr unsigned kVariantShift = 2;

class CompactRoutes final : public BendSource {
 public:
  explicit CompactRoutes(std::vector<std::uint8_t> code) : code_(std::move(code)) {}

  void append_bends(EdgeId e, Edge, Point at_u, Point at_v,
                    std::vector<Point>& out) const override {
    const unsigned code = code_[e];
    const bool backward = (code & kBackwardBit) != 0;
    const Site tail = site_of(backward ? at_v : at_u);
    const Site head = site_of(backward ? at_u : at_v);
    const Word word = word_of({(code & kRedBit) != 0, tail.type, head.type,
                               head.column > tail.column, code >> kVariantShift});
    const Letters from = letters_of(tail);
    const auto before = static_cast<std::ptrdiff_t>(out.size());
    append_bends_of(word, from, long_lengths(word, from, letters_of(head)), out);
    if (backward) std::reverse(out.begin() + before, out.end());
  }

 private:
  std::vector<std::uint8_t> code_;
};

std::vector<std::uint8_t> codes(const Graph& graph, const Decomposition& links,
                                const Strip& strip) {
  std::vector<std::uint8_t> code(graph.num_edges());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const Role role : {kGreenOut, kRedOut}) {
      const HalfEdge edge = links.at[v][role];
      if (edge.to == kNobody) continue;
      const unsigned backward = v < edge.to ? 0 : kBackwardBit;  // edges ascend
      const unsigned variant = strip.variant()[edge.edge];
      code[edge.edge] = static_cast<std::uint8_t>((is_red(role) ? kRedBit : 0) | backward |
                                                  (variant << kVariantShift));
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

Drawing lift(const Graph& graph, const Decomposition& links, const Strip& strip) {
  const Vertex n = graph.num_vertices();
  Coordinates vertices(n, 4 * (std::int64_t{strip.size().columns} + strip.size().rows) + 4);
  for (Vertex v = 0; v < n; ++v) vertices.set(v, to_point(letters_of(strip.site(v))));
  return Drawing("compact", kCubeLattice, std::move(vertices), graph.shared_edges(),
                 std::make_shared<CompactRoutes>(codes(graph, links, strip)));
}

}  // namespace ar3d::compact
