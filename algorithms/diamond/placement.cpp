// The four invariants of a placement, from which Lemmas 1.1 and 1.2 conclude that the drawing is
// right; only tests and builds with AR3D_CHECKS check them. O(n + m).
#include "ar3d/algorithms/diamond/placement.h"

namespace ar3d::diamond {
namespace {

/// The order increases, and every odd cycle can turn one path edge into a Z.
template <class Along, class Across>
bool keeps_order_and_c2(const Items& items, Along along, Across across) {
  for (std::size_t p = 1; p < items.vertex.size(); ++p) {
    if (along(items.vertex[p - 1]) >= along(items.vertex[p])) return false;
  }
  for (std::uint32_t item = 0; item < items.count(); ++item) {
    if (!items.is_cycle(item) || items.size(item) % 2 == 0) continue;
    bool able = false;
    const auto v = items.of(item);
    for (std::size_t i = 1; i < v.size(); ++i) {
      able = able || z_distance(along(v[i]) - along(v[i - 1]), across(v[i]) - across(v[i - 1])) > 0;
    }
    if (!able) return false;
  }
  return true;
}

}  // namespace

bool adjacent(const Graph& graph, Vertex u, Vertex v) {
  const auto row = graph.incident(u);
  return std::any_of(row.begin(), row.end(), [v](const HalfEdge& half) { return half.to == v; });
}

bool fits_theorem_box(const std::array<std::int64_t, 3>& extents, std::uint64_t n) {
  const auto size = static_cast<std::int64_t>(n);
  return 3 * extents[0] <= 16 * size && 3 * extents[1] <= 16 * size && extents[2] <= 8 * size;
}

bool keeps_invariants(const Graph& graph, const Placement& placement) {
  const auto x = [&](Vertex v) { return placement.at[v].X; };
  const auto y = [&](Vertex v) { return placement.at[v].Y; };
  for (const PlanePoint p : placement.at) {
    if ((p.X + p.Y) % 2 != 0) return false;
  }
  for (const auto [u, v] : graph.edges()) {
    if (std::abs(x(u) - x(v)) == std::abs(y(u) - y(v))) return false;
  }
  return keeps_order_and_c2(placement.green, x, y) && keeps_order_and_c2(placement.red, y, x);
}

}  // namespace ar3d::diamond
