// Steps G.9 to G.13: a vertex of a closure, by its neighbours that are drawn: none (leaf), one
// (pass), two of the cycle (the paper's case ii), three of it (iii), two otherwise (iv, merge),
// three otherwise (Repair G.15, for which the text has no rule). Every vertex but those of `three`
// gets a new height. Paths that leave their plane do so right of the front, not at once (Repair
// G.14). Cost: O(1) a vertex.
#include <algorithm>

#include "ar3d/algorithms/grid_paper/builder.h"
#include "ar3d/base/error.h"

namespace ar3d::grid_paper {

void DrawingBuilder::add_vertex(Vertex u) {
  std::vector<Vertex> below;
  for (const HalfEdge half : graph_.incident(u)) {
    if (is_drawn(half.to)) below.push_back(half.to);
  }
  const bool of_cycle = std::ranges::none_of(below, [&](Vertex v) { return is_tree(v); });
  if (below.empty()) {
    place(u, {next_x_, front_, top_ += 2}, VertexKind::tree);
    next_x_ += 2;
  } else if (below.size() == 1) {
    const SkewPoint v = at_[below[0]];
    const std::int64_t y = go_up(below[0], front_);
    place(u, {v.x, y, top_ += 2}, VertexKind::tree);
    route(below[0], u, {{v.x, y, v.z}});
  } else if (below.size() == 2) {
    if (of_cycle) return add_two_of_cycle(u, below[0], below[1]);
    if (is_tree(below[0])) return add_merge(u, below[0], below[1]);
    add_merge(u, below[1], below[0]);
  } else if (of_cycle && at_[below[0]].x != at_[below[1]].x) {
    add_k4_top(u, below);
  } else if (of_cycle) {
    std::ranges::sort(below, {}, [&](Vertex v) { return at_[v].y; });
    add_two_of_cycle(u, below[0], below[1]);
    const auto [x, y, z] = at_[below[2]];
    route(below[2], u, {{x, y + 1, z}, {x, y + 1, top_ - 1}, {x, y, top_}});
    ++census_.three_of_cycle;
  } else {
    add_three(u, below);
  }
}

/// Returns how far v goes to the right before it goes up.
std::int64_t DrawingBuilder::go_up(Vertex v, std::int64_t front) const {
  return is_tree(v) ? front + 1 : at_[v].y + 1;
}

/// Step G.10, case ii: u right of w and above it; the path from v passes over that from w.
void DrawingBuilder::add_two_of_cycle(Vertex u, Vertex v, Vertex w) {
  if (at_[v].y > at_[w].y) std::swap(v, w);
  const auto [x, y, z] = at_[w];
  top_ += 2;
  place(u, {x, y + 1, top_}, VertexKind::tree);
  const std::int64_t left = at_[v].y + 1;
  route(v, u, {{x, left, z}, {x, left, top_ + 1}, {x, y, top_ + 1}});
  route(w, u, {{x, y + 1, z}});
  ++census_.same_cycle;
}

/// Repair G.6: the fourth vertex of K4, in a horizontal plane above the others.
void DrawingBuilder::add_k4_top(Vertex u, std::vector<Vertex> below) {
  std::ranges::sort(below, {}, [&](Vertex v) { return at_[v].x; });
  const SkewPoint a = at_[below[0]], c = at_[below[1]], b = at_[below[2]];
  const std::int64_t y = std::max(a.y + 2, b.y + 4), z = top_ += 2;
  expect(y < c.y, "the run of K4 has length 2");
  place(u, {c.x, y, z}, VertexKind::tree);
  route(below[0], u, {{a.x, a.y + 1, a.z}, {a.x, a.y + 1, z}, {a.x, y, z}});
  route(below[2], u, {{b.x, b.y + 1, b.z}, {b.x, b.y + 1, z}, {b.x, y - 2, z}});
  route(below[1], u, {{c.x, c.y + 1, c.z}, {c.x, c.y + 1, z - 1}, {c.x, c.y, z}});
  ++census_.k4s;
}

/// Repair G.14: p goes to the plane x right of the front and reaches u, two right of it, from
/// below.
void DrawingBuilder::switch_to(Vertex p, Vertex u, std::int64_t front) {
  const SkewPoint from = at_[p], to = at_[u];
  const std::int64_t y = repairs_.switch_late ? front + 2 : from.y + 1;
  const std::int64_t beside = y + std::max<std::int64_t>(0, from.x - to.x);
  route(p, u, {{from.x, y, from.z}, {to.x, beside, from.z}, {to.x, to.y, from.z}});
}

/// Returns where a vertex stands that p switches to.
std::int64_t DrawingBuilder::beyond_switch(Vertex p, std::int64_t x, std::int64_t front) const {
  return front + 3 + std::max<std::int64_t>(0, at_[p].x - x);
}

/// Step G.12, case iv: p switches to the plane of q, which passes over it.
void DrawingBuilder::add_merge(Vertex u, Vertex p, Vertex q) {
  const std::int64_t front = front_, x = at_[q].x;
  top_ += 2;
  place(u, {x, beyond_switch(p, x, front), top_}, VertexKind::tree);
  switch_to(p, u, front);
  arrive(q, u, 1, front);
  ++census_.merges;
}

/// Step G.13 (Repair G.15): p turns back in its own horizontal plane and enters u from the right, q
/// arrives from above and r from below.
void DrawingBuilder::add_three(Vertex u, const std::vector<Vertex>& below) {
  const std::int64_t front = front_;
  Vertex p = below[0], q = below[1], r = below[2];
  bool share = at_[q].x == at_[r].x;
  for (int i = 0; i < 2 && !share; ++i) {
    const Vertex first = p;
    p = q, q = r, r = first;
    share = at_[q].x == at_[r].x;
  }
  if (share) {
    const bool from_above = at_[p].z > at_[q].z;
    if (in_layer(q) && in_layer(r) ? (at_[q].y < at_[r].y) != from_above : in_layer(r)) {
      std::swap(q, r);
    }
  } else {
    const auto height = [&](Vertex v) { return is_tree(v) ? at_[v].z : old_top_; };
    if (height(q) > height(p)) std::swap(p, q);
    if (height(r) > height(p)) std::swap(p, r);
    if (!is_tree(r)) std::swap(q, r);
  }
  expect(is_tree(p) && at_[p].z > old_top_, "the vertex that turns back is of this stage");
  const std::int64_t x = at_[q].x, y = share ? front + 3 : beyond_switch(r, x, front);
  place(u, {x, y, at_[p].z}, VertexKind::tree);
  turn_back(p, u);
  arrive(q, u, 1, front);
  if (share) {
    arrive(r, u, -1, front);
  } else {
    switch_to(r, u, front);
  }
  ++census_.threes;
}

void DrawingBuilder::turn_back(Vertex p, Vertex u) {
  const SkewPoint from = at_[p], to = at_[u];
  const std::int64_t z = from.z, y = to.y + 3;
  if (from.x < to.x) {
    route(p, u, {{from.x, y, z}, {to.x - 1, y, z}, {to.x, y - 1, z}});
  } else {
    const std::int64_t beyond = y + from.x - to.x - 1;
    route(p, u, {{from.x, y, z}, {to.x + 1, beyond, z}, {to.x, beyond, z}});
  }
}

/// In the plane of u, from above (side 1) or below (side -1). A cycle above u comes down from the
/// end of its leg, into the region that Repair G.13 keeps free.
void DrawingBuilder::arrive(Vertex q, Vertex u, std::int64_t side, std::int64_t front) {
  const auto [x, y, z] = at_[q];
  const SkewPoint to = at_[u];
  const std::int64_t height = to.z + side, last = side > 0 ? to.y - 1 : to.y;
  const std::int64_t right = go_up(q, front);
  if (height > z && is_tree(q) && side < 0) {
    route(q, u, {{x, to.y, z}});
  } else if (height > z) {
    route(q, u, {{x, right, z}, {x, right, height}, {x, last, height}});
  } else {
    const std::int64_t down = right + z - height;
    expect(!is_tree(q) && down <= front, "a way down ends left of the front");
    route(q, u, {{x, right, z}, {x, down, height}, {x, last, height}});
    ++census_.ways_down;
  }
}

}  // namespace ar3d::grid_paper
