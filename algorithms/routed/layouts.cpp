// Steps R.2 and R.7, where vertices stand in a box: a rough placement scaled into it, a layout scaled
// into another box, and a routing of which layers are cut off. Cost: O(n + length of all routes),
// and a few points tried for each vertex that needs one.
#include "ar3d/algorithms/routed/layouts.h"

#include <cstdlib>

namespace ar3d::routed {
namespace {

constexpr int kApart = 6;  // so far from where it belongs a vertex goes to stand alone

/// True if a step from p leads to a vertex or out of the box.
bool is_crowded(const PointClass& points, const CostBox& taken, Spot p) {
  for (int d = 0; d < points.num_directions(); ++d) {
    const Spot q = p + points.step(d);
    const bool is_inside = taken.contains(q);
    if (is_inside ? taken.has_vertex(taken.index(q)) : taken.limits().longest() > 6) return true;
  }
  return false;
}

/// The nearest free point of the cube shell of that radius.
std::optional<Spot> free_in_shell(const PointClass& points, const CostBox& taken, Spot wanted,
                                  int radius, bool stands_alone) {
  std::optional<Spot> best;
  int nearest = 0;
  for (int x = -radius; x <= radius; ++x) {
    for (int y = -radius; y <= radius; ++y) {
      const bool is_inner = std::abs(x) < radius && std::abs(y) < radius;
      for (int z = -radius; z <= radius; z += is_inner ? std::max(1, 2 * radius) : 1) {
        const Spot p = wanted + Spot{x, y, z};
        if (!points.contains(p) || !taken.contains(p)) continue;
        const int i = taken.index(p);
        const int distance = x * x + y * y + z * z;
        if (taken.has_vertex(i) || taken.uses(i) > 0 || (best && distance >= nearest)) continue;
        if (stands_alone && is_crowded(points, taken, p)) continue;
        best = p;
        nearest = distance;
      }
    }
  }
  return best;
}

std::optional<Spot> nearest_free(const PointClass& points, const CostBox& taken, Spot wanted,
                                 bool stands_alone) {
  for (int radius = 0; radius <= taken.limits().longest(); ++radius) {
    const auto found =
        free_in_shell(points, taken, wanted, radius, stands_alone && radius < kApart);
    if (found) return found;
  }
  return std::nullopt;
}

/// Each vertex as near as possible to where it is wanted.
template <class Wanted>
std::optional<Layout> settled(const PointClass& points, std::vector<std::uint8_t> frames,
                              const Limits& limits, const Wanted& wanted) {
  Layout layout{limits, {}, std::move(frames)};
  CostBox taken(points, limits);
  for (Vertex v = 0; v < layout.frame.size(); ++v) {
    const auto at = nearest_free(points, taken, wanted(v), true);
    if (!at) return std::nullopt;
    layout.at.push_back(*at);
    taken.put_vertex(taken.index(*at));
  }
  return layout;
}

/// Middle of a cell, of `cells` that share a side with so many points.
int middle(int cell, int cells, int points) {
  return ((2 * cell + 1) * (points - 1) + cells) / (2 * cells);
}

/// Coordinate x of 0 ... from - 1, scaled to 0 ... to - 1.
int scaled(int x, int from, int to) {
  return from == 1 ? (to - 1) / 2 : (2 * x * (to - 1) + from - 1) / (2 * (from - 1));
}

}  // namespace

std::optional<Layout> spread(const PointClass& points, const Placement& placement,
                             std::vector<std::uint8_t> frames, const Limits& limits) {
  return settled(points, std::move(frames), limits, [&](Vertex v) {
    const Spot cell = placement.of[v];
    const Spot sides = limits.sides();
    return limits.low + Spot{middle(cell.x, placement.cells.x, sides.x),
                             middle(cell.y, placement.cells.y, sides.y),
                             middle(cell.z, placement.cells.z, sides.z)};
  });
}

std::optional<Layout> rescaled(const PointClass& points, const Layout& layout,
                               const Limits& limits) {
  return settled(points, layout.frame, limits, [&](Vertex v) {
    const Spot p = layout.at[v] - layout.limits.low;
    const Spot from = layout.limits.sides();
    const Spot to = limits.sides();
    return limits.low +
           Spot{scaled(p.x, from.x, to.x), scaled(p.y, from.y, to.y), scaled(p.z, from.z, to.z)};
  });
}

std::optional<Routing> cut(const Graph& graph, const PointClass& points, Routing routing,
                           const Limits& limits) {
  Layout& layout = routing.layout;
  layout.limits = limits;
  CostBox taken(points, limits);
  std::vector<Vertex> outside;
  std::vector<bool> is_outside(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (limits.contain(layout.at[v])) {
      taken.put_vertex(taken.index(layout.at[v]));
    } else {
      is_outside[v] = true;
      outside.push_back(v);
    }
  }
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const auto [u, v] = graph.edge(e);
    Route& route = routing.routes[e];
    bool stays = !is_outside[u] && !is_outside[v];
    for_each_corner(points, layout.at[u], route, [&](Spot p) { stays &= limits.contain(p); });
    if (stays) {
      taken.put(layout.at[u], route);
    } else {
      route = {};
    }
  }
  for (const Vertex v : outside) {
    const auto at = nearest_free(points, taken, layout.at[v], false);
    if (!at) return std::nullopt;
    layout.at[v] = *at;
    taken.put_vertex(taken.index(*at));
  }
  return routing;
}

std::vector<std::uint8_t> choose_frames(const Graph& graph, const PointClass& points, int bends,
                                        RandomStream random) {
  std::vector<std::uint8_t> frames(graph.num_vertices());
  if (points.is_body() && bends != 4) return frames;
  const auto count = static_cast<std::uint32_t>(points.frames().size());
  for (std::uint8_t& frame : frames) frame = static_cast<std::uint8_t>(random.below(count));
  if (!points.is_body()) return frames;
  bool is_better = true;  // each change adds an edge to the cut, so this ends
  while (is_better) {
    is_better = false;
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      std::size_t like_v = 0;
      for (const HalfEdge& half : graph.incident(v)) like_v += frames[half.to] == frames[v];
      if (2 * like_v <= graph.degree(v)) continue;
      frames[v] ^= 1;
      is_better = true;
    }
  }
  return frames;
}

Limits tight_limits(const Graph& graph, const PointClass& points, const Routing& routing) {
  const Layout& layout = routing.layout;
  Limits box{layout.at.at(0), layout.at.at(0)};
  const auto add = [&](Spot p) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  };
  for (const Spot at : layout.at) add(at);
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    for_each_corner(points, layout.at[graph.edge(e).u], routing.routes[e], add);
  }
  return box;
}

}  // namespace ar3d::routed
