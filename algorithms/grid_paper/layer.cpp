// Steps G.3, G.6 and G.7, the paper's lemma "add flat cycle" up to the closure: vertical planes for
// a cycle's vertices, its layer left of and above all that is drawn (Repair G.9), and the edges
// from it to what is drawn. A path leaves an old vertex to the right, goes up there and comes back
// along e_Y - e_Z, so it arrives from the right, where nothing old is in its way. Cost: O(1) a
// vertex beside the flat cycle.
#include <algorithm>

#include "ar3d/algorithms/grid_paper/builder.h"
#include "ar3d/base/error.h"

namespace ar3d::grid_paper {

Vertex DrawingBuilder::third_neighbour(Vertex v) const {
  for (const HalfEdge half : graph_.incident(v)) {
    if (!in_layer(half.to)) return half.to;
  }
  return v;
}

std::optional<Vertex> DrawingBuilder::old_neighbour(Vertex u) const {
  for (const HalfEdge half : graph_.incident(u)) {
    if (is_drawn(half.to) && !in_layer(half.to)) return half.to;
  }
  return std::nullopt;
}

/// Step G.3. K4 is the only component with a triangle whose vertices share their third neighbour.
void DrawingBuilder::choose_planes(const std::vector<Vertex>& cycle, bool is_k4) {
  if (is_k4) {  // Repair G.6
    for (std::size_t i = 0; i < 3; ++i) at_[cycle[i]].x = next_x_ + (i == 0 ? 0 : i == 1 ? 4 : 2);
    next_x_ += 6;
    return;
  }
  for (const Vertex v : cycle) {
    const Vertex u = third_neighbour(v);
    if (at_[v].x == kNoPlane) {
      const auto w = u == v ? std::nullopt : is_drawn(u) ? std::optional(u) : old_neighbour(u);
      at_[v].x = w ? at_[*w].x : next_x_;
      if (!w) next_x_ += 2;
    }
    if (u == v || is_drawn(u)) continue;
    for (const HalfEdge half : graph_.incident(u)) {
      if (in_layer(half.to)) at_[half.to].x = at_[v].x;
    }
  }
}

/// Repair G.7: an odd cycle begins with two vertices of which the second has the larger x.
void DrawingBuilder::turn(std::vector<Vertex>& cycle) const {
  const auto x = [&](std::size_t i) { return at_[cycle[i % cycle.size()]].x; };
  std::size_t i = 0;
  while (i < cycle.size() && x(i) == x(i + 1)) ++i;
  expect(i < cycle.size(), "an odd cycle has vertices in different planes");
  const bool backwards = x(i) > x(i + 1);
  const std::size_t first = (backwards ? i + 2 : i) % cycle.size();
  std::rotate(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(first), cycle.end());
  if (backwards) std::reverse(cycle.begin(), cycle.end());
}

/// Returns how far the path from an old vertex w comes back along e_Y - e_Z, to the end of v's leg.
std::int64_t DrawingBuilder::way_back(Vertex v, Vertex w) const {
  return go_up(w, old_front_) - at_[v].y - 1;
}

/// Step G.6, z.
std::int64_t DrawingBuilder::height_of_layer(const std::vector<Vertex>& cycle) const {
  if (old_top_ < 0) return 0;  // the first thing drawn
  std::int64_t longest = 0, through = 0;
  for (const Vertex v : cycle) {
    const Vertex u = third_neighbour(v);
    const auto w = u == v || is_drawn(u) ? std::optional(u) : old_neighbour(u);
    if (u == v || !w) continue;
    longest = std::max(longest, way_back(v, *w));
    through += is_drawn(u) ? 0 : 1;
  }
  if (options_.needed_gap && longest == 0) return old_top_ + 4;  // no connection
  const std::int64_t need = options_.needed_gap ? longest : old_front_ + 1 - left_;
  return old_top_ + 2 * ((need + 1) / 2) + 2 * through + 6;
}

/// Steps G.4 to G.6: the layer, left of and above all that is drawn.
void DrawingBuilder::lay(const std::vector<Vertex>& cycle, bool is_k4) {
  const std::size_t k = cycle.size();
  std::vector<std::int64_t> x;
  for (const Vertex v : cycle) x.push_back(at_[v].x);
  const FlatCycle flat = draw_flat_cycle(x, options_.spread, is_k4 ? 2 : 1, repairs_.spread);
  census_.spread += flat.spread;
  std::int64_t low = flat.at[0].y(), high = low;
  for (const LayerPoint& p : flat.at) high = std::max(high, p.y() + 1);
  for (const auto& bends : flat.bends) {
    for (const LayerPoint& p : bends) low = std::min(low, p.y());
  }
  layer_right_ = repairs_.left ? left_ - 4 : 0;
  const std::int64_t move = layer_right_ - high;
  left_ = std::min(left_, low + move);
  for (std::size_t i = 0; i < k; ++i) {
    place(cycle[i], {x[i], flat.at[i].y() + move, 0}, VertexKind::cycle);
  }
  top_ = layer_z_ = height_of_layer(cycle);
  for (const Vertex v : cycle) at_[v].z = layer_z_;
  for (std::size_t i = 0; i < k; ++i) {
    const auto& bends = flat.bends[i];
    const auto at = [&](std::size_t j) {
      return SkewPoint{bends[j].x, bends[j].y() + move, layer_z_};
    };
    const Vertex from = cycle[i + 1 < k ? i : 0], to = cycle[i + 1 < k ? i + 1 : k - 1];
    if (bends.size() == 1) {
      route(from, to, {at(0)});
    } else {
      route(from, to, {at(0), at(1), at(2)});
    }
  }
  for (const Vertex v : cycle) {
    const Vertex w = third_neighbour(v);
    if (w != v && is_drawn(w)) connect(v, w);
  }
}

/// Step G.7: an edge from a cycle vertex v to an old vertex w in its plane.
void DrawingBuilder::connect(Vertex v, Vertex w) {
  const auto [x, y, z] = at_[v];
  const std::int64_t r = go_up(w, old_front_);
  route(w, v, {{x, r, at_[w].z}, {x, r, z - way_back(v, w)}, {x, y + 1, z}});
  ++census_.connections;
}

void DrawingBuilder::add_cycle(const GrowthStage& stage) {
  std::vector<Vertex> cycle = stage.cycle;
  for (const Vertex v : cycle) layer_of_[v] = layer_ + 1;
  ++layer_;
  old_top_ = top_;
  old_front_ = front_;
  ++census_.cycles;
  census_.on_cycles += static_cast<std::int64_t>(cycle.size());
  const Vertex u = third_neighbour(cycle[0]);
  const bool is_k4 = repairs_.k4 && cycle.size() == 3 && u != cycle[0] &&
                     third_neighbour(cycle[1]) == u && third_neighbour(cycle[2]) == u;
  choose_planes(cycle, is_k4);
  if (cycle.size() % 2 == 1 && !is_k4 && repairs_.turned) turn(cycle);
  lay(cycle, is_k4);
  add_between(stage);
}

}  // namespace ar3d::grid_paper
