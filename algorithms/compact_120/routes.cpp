// Lemma D.10, and the drawing in space. The sites of the two ends and one byte per edge give the
// word and with it all five bends, so bends are computed when somebody reads them, in O(1).
#include "ar3d/algorithms/compact_120/routes.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace ar3d::compact_120 {
namespace {

constexpr unsigned kArrivalMask = 3;
constexpr unsigned kBackwardBit = 4;  ///< the tail is the edge's second end
constexpr unsigned kVariantShift = 3;

class Compact120Routes final : public BendSource {
 public:
  explicit Compact120Routes(std::vector<std::uint8_t> code) : code_(std::move(code)) {}

  void append_bends(EdgeId e, Edge, Point at_u, Point at_v,
                    std::vector<Point>& out) const override {
    const unsigned code = code_[e];
    const bool backward = (code & kBackwardBit) != 0;
    const Quad tail = quad_of(site_of(backward ? at_v : at_u));
    const Quad head = quad_of(site_of(backward ? at_u : at_v));
    const Shape shape{head[0] > tail[0], static_cast<Arrival>(code & kArrivalMask),
                      code >> kVariantShift};
    const auto before = static_cast<std::ptrdiff_t>(out.size());
    Route(shape, tail, head).append_bends(out);
    if (backward) std::reverse(out.begin() + before, out.end());
  }

 private:
  std::vector<std::uint8_t> code_;
};

std::vector<std::uint8_t> codes(const Graph& graph, const Strip& strip) {
  std::vector<std::uint8_t> code(graph.num_edges());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const Link& link : strip.links().at[v]) {
      if (!link.is_set() || link.is_out == 0) continue;
      const unsigned backward = v < link.to ? 0 : kBackwardBit;  // first ends have smaller numbers
      const unsigned variant = strip.variant()[link.edge];
      code[link.edge] = static_cast<std::uint8_t>(link.at | backward | (variant << kVariantShift));
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
                 std::make_shared<Compact120Routes>(codes(graph, strip)));
}

}  // namespace ar3d::compact_120
