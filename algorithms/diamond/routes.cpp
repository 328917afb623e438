// The routes in space: two turns and the apex of every edge, from one number per edge. A route's
// height is the distance in the plane from its nearer end (Lemma 1.2), so bends are computed when
// they are read and cost O(1).
#include "ar3d/algorithms/diamond/routes.h"

#include "ar3d/base/parallel.h"

namespace ar3d::diamond {
namespace {

class DiamondRoutes final : public BendSource {
 public:
  explicit DiamondRoutes(UnwrittenVector<std::int32_t> code) : code_(std::move(code)) {}

  /// The two turns and the apex, in order. The apex is halfway along the plane path; the placement
  /// makes the path's length even and keeps the apex off the turns.
  void append_bends(EdgeId e, Edge, Point at_u, Point at_v,
                    std::vector<Point>& out) const override {
    const bool red = code_[e] & 1;
    const std::int64_t track = (code_[e] - (red ? 1 : 0)) / 2;
    const auto [a_u, b_u] = seen(at_u, red);
    const auto [a_v, b_v] = seen(at_v, red);
    const std::int64_t first = std::abs(track - b_u);
    const std::int64_t across = std::abs(a_v - a_u);
    const std::int64_t last = std::abs(track - b_v);
    const std::int64_t half = (first + across + last) / 2;
    const auto lifted = [red](std::int64_t a, std::int64_t b, std::int64_t height) {
      return red ? Point{b - a, b + a, -height} : Point{a - b, a + b, height};
    };
    const Point turn_u = lifted(a_u, track, std::min(first, last + across));
    const Point turn_v = lifted(a_v, track, std::min(last, first + across));
    if (half < first) {
      const Point apex = lifted(a_u, b_u + (track > b_u ? half : -half), half);
      out.insert(out.end(), {apex, turn_u, turn_v});
    } else if (half < first + across) {
      const std::int64_t on = half - first;
      const Point apex = lifted(a_u + (a_v > a_u ? on : -on), track, half);
      out.insert(out.end(), {turn_u, apex, turn_v});
    } else {
      const Point apex = lifted(a_v, b_v + (track > b_v ? half : -half), half);
      out.insert(out.end(), {turn_u, turn_v, apex});
    }
  }

 private:
  /// (X, Y) of a vertex for a green edge, (Y, X) for a red one; x = X - Y and y = X + Y.
  static std::pair<std::int64_t, std::int64_t> seen(Point p, bool red) {
    const std::int64_t X = (p.x + p.y) / 2;
    const std::int64_t Y = (p.y - p.x) / 2;
    return red ? std::pair{Y, X} : std::pair{X, Y};
  }

  UnwrittenVector<std::int32_t> code_;
};

}  // namespace

Drawing lift(const Graph& graph, const Placement& placement, Tracks tracks) {
  const auto n = placement.at.size();
  std::int32_t bound = 0;  // X and Y are not negative, so X + Y bounds both |X - Y| and X + Y
  for (const PlanePoint p : placement.at) bound = std::max(bound, p.X + p.Y);
  Coordinates vertices(n, bound);
  const auto threads = threads_for(n);
  for_ranges_in_threads(threads, n, [&](std::uint32_t, std::size_t begin, std::size_t end) {
    vertices.fill(begin, end, [&](std::size_t v) {
      const auto [X, Y] = placement.at[v];
      return Point{X - Y, X + Y, 0};
    });
  });
  return Drawing("diamond", kCubeLattice, std::move(vertices), graph.shared_edges(),
                 std::make_shared<DiamondRoutes>(std::move(tracks.code)));
}

}  // namespace ar3d::diamond
