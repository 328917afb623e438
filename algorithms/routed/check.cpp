// Lemma R.2, decided for a routing at hand before it is kept: what the negotiation believes about
// its box counts for nothing here. Every point of every route is written down and sorted; a point
// that stands there twice is a meeting. Cost: O(l log l) for l points.
#include "ar3d/algorithms/routed/check.h"

#include <algorithm>
#include <compare>
#include <tuple>

namespace ar3d::routed {
namespace {

bool has_allowed_turns(const PointClass& points, int bends, const Route& route) {
  if (!route || route.segments > bends + 1) return false;
  for (std::size_t s = 0; s < route.segments; ++s) {
    if (route.direction[s] >= points.num_directions() || route.length[s] < 1) return false;
    if (s > 0 && !has(points.turns(route.direction[s - 1]), route.direction[s])) return false;
  }
  return true;
}

}  // namespace

bool is_drawing(const Graph& graph, const PointClass& points, int bends, const Routing& routing) {
  const Layout& layout = routing.layout;
  if (layout.at.size() != graph.num_vertices() || layout.frame.size() != graph.num_vertices() ||
      routing.routes.size() != graph.num_edges()) {
    return false;
  }
  std::vector<std::tuple<int, int, int>> passed;
  const auto pass = [&](Spot p) {
    passed.emplace_back(p.x, p.y, p.z);
    return points.contains(p) && layout.limits.contain(p);
  };
  std::vector<Directions> free;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (layout.frame[v] >= points.frames().size() || !pass(layout.at[v])) return false;
    free.push_back(points.frames()[layout.frame[v]]);
  }
  const auto takes_arm = [&](Vertex v, int d) {
    const bool is_free = has(free[v], d);
    free[v] = without(free[v], d);
    return is_free;
  };
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const Route& route = routing.routes[e];
    if (!has_allowed_turns(points, bends, route)) return false;
    const auto [u, v] = graph.edge(e);
    if (!takes_arm(u, route.direction[0]) ||
        !takes_arm(v, PointClass::opposite(route.direction[route.segments - 1]))) {
      return false;
    }
    Spot p = layout.at[u];
    for (std::size_t s = 0; s < route.segments; ++s) {
      for (int t = 0; t < route.length[s]; ++t) {
        p = p + points.step(route.direction[s]);
        const bool is_end = s + 1 == route.segments && t + 1 == route.length[s];
        if (!is_end && !pass(p)) return false;
      }
    }
    if (!(p == layout.at[v])) return false;
  }
  std::sort(passed.begin(), passed.end());
  return std::adjacent_find(passed.begin(), passed.end()) == passed.end();
}

}  // namespace ar3d::routed
