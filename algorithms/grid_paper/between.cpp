// Step G.8: the vertices between the new cycle and what was drawn before. One with a neighbour on
// the cycle stands on a bend of the path between the two, at an even height of its own (Repair
// G.10); one with two is drawn above the cycle and joined from there. All are drawn before anything
// switches planes, and where a later path has to come down from the cycle past them, the front is
// moved out of its way (Repair G.13). Cost: O(log n) a vertex.
#include <algorithm>

#include "ar3d/algorithms/grid_paper/builder.h"

namespace ar3d::grid_paper {

void DrawingBuilder::add_between(const GrowthStage& stage) {
  gap_heights_.clear();
  for (const Vertex u : stage.between) {
    std::vector<Vertex> on_cycle;
    for (const HalfEdge half : graph_.incident(u)) {
      if (in_layer(half.to)) on_cycle.push_back(half.to);
    }
    const Vertex w = *old_neighbour(u);
    if (on_cycle.size() == 1) {
      add_middle(u, on_cycle[0], w);
    } else {
      add_past_layer(u, on_cycle[0], on_cycle[1], w);
    }
  }
  if (repairs_.cleared) clear_front(stage.closure);
}

void DrawingBuilder::add_middle(Vertex u, Vertex v, Vertex w) {
  const auto [x, y, z] = at_[v];
  const std::int64_t r = go_up(w, old_front_), bend = z - way_back(v, w);
  std::int64_t h = bend;
  if (repairs_.own_heights) {
    h -= h & 1;
    while (!gap_heights_.insert(h).second) h -= 2;
  }
  gap_heights_.insert(h);
  place(u, {x, r, h}, VertexKind::tree);
  route(w, u, {{x, r, at_[w].z}});
  if (h == bend) {
    route(u, v, {{x, y + 1, z}});
  } else {
    route(u, v, {{x, r - 1, h + 1}, {x, r - 1, bend + 1}, {x, y + 1, z}});
    ++census_.moved;
  }
  ++census_.middles;
}

/// Repair G.11: the path from w passes to the right of the whole layer.
void DrawingBuilder::add_past_layer(Vertex u, Vertex v, Vertex other, Vertex w) {
  add_two_of_cycle(u, v, other);
  const auto [x, y, z] = at_[u];
  const std::int64_t leg = repairs_.past_layer ? layer_right_ + 1 : y + 1, r = go_up(w, old_front_);
  route(w, u, {{x, r, at_[w].z}, {x, r, z - (r - leg)}, {x, leg, z}});
  ++census_.past_layer;
}

void DrawingBuilder::clear_front(const std::vector<Vertex>& closure) {
  const auto is_needed = [&](Vertex u) {
    const auto incident = graph_.incident(u);
    return std::ranges::any_of(incident, [&](HalfEdge half) { return in_layer(half.to); }) &&
           std::ranges::any_of(incident, [&](HalfEdge half) { return in_gap(half.to); });
  };
  if (std::ranges::none_of(closure, is_needed)) return;
  front_ = std::max(front_, layer_right_ + layer_z_ - *gap_heights_.begin() + 4);
}

}  // namespace ar3d::grid_paper
