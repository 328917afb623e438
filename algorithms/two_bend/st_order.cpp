// Step 2.3: Tarjan's st-order of a block from its lowpoints, by sizes of subtrees instead of a
// linked list, and Step 2.4: the repair of its end, which is this project's. Cost: O(size of the
// block).
#include "ar3d/algorithms/two_bend/st_order.h"

#include <algorithm>
#include <utility>

#include "ar3d/base/error.h"

namespace ar3d::two_bend {

StOrder::StOrder(const LocalGraph& graph, const Blocks& blocks)
    : graph_(graph), blocks_(blocks), seen_(graph.size(), false), number_(graph.size()) {
  visited_.reserve(graph.size());
  numbered_.reserve(graph.size());
}

const LongVector<Vertex>& StOrder::order(Vertex s, Vertex t) {
  expect(s != t && !blocks_.is_bridge(s, t), "an st-order runs between two vertices of one block");
  search(s, t);
  find_lows();
  place_in_preorder();
  for (const Vertex v : visited_) seen_[v] = false;
  return list_;
}

/// Depth-first search of the block from t, with the virtual tree edge s - t above it.
void StOrder::search(Vertex s, Vertex t) {
  visited_.assign(1, s);
  numbered_.assign(1, {});
  seen_[s] = true;
  number_[s] = 0;
  turns_.assign(1, {t, s, 0});
  while (!turns_.empty()) {
    const Turn turn = turns_.back();
    turns_.pop_back();
    if (!seen_[turn.to]) visit(turn);
  }
}

/// Neighbours seen before lie on the way back to s; low is the least of their numbers but the
/// parent's. Nothing waits for a number: the search goes on while they come.
void StOrder::visit(Turn turn) {
  const Vertex v = turn.to;
  const auto number = static_cast<Vertex>(visited_.size());
  seen_[v] = true;
  number_[v] = number;
  visited_.push_back(v);
  Vertex low = number;
  const NeighbourList& near = graph_.neighbours[v];
  for (std::size_t k = near.degree(); k-- > 0;) {
    const Vertex u = near.to[k];
    if (blocks_.is_bridge(v, u)) continue;
    if (!seen_[u]) {
      ask_for(graph_.neighbours, u);
      turns_.push_back({u, v, number});
    } else if (u != turn.from) {
      low = std::min(low, number_[u]);
    }
  }
  numbered_.push_back({.parent = turn.parent, .low = low});
}

void StOrder::find_lows() {
  for (std::size_t i = numbered_.size(); i-- > 2;) {
    Numbered& parent = numbered_[numbered_[i].parent];
    parent.low = std::min(parent.low, numbered_[i].low);
    parent.size += numbered_[i].size;
  }
}

/// Tarjan inserts the vertices in preorder, each directly before or after its parent. So a subtree
/// lies together, and a child's lies next to all those of its parent's that were inserted on this
/// side before.
void StOrder::place_in_preorder() {
  list_.resize(visited_.size());
  list_[0] = visited_[0];
  plus_.assign(numbered_.size(), false);
  numbered_[1].begin = 1;
  numbered_[1].end = static_cast<std::uint32_t>(numbered_.size());
  for (Vertex i = 2; i < numbered_.size(); ++i) {
    Numbered& here = numbered_[i];
    Numbered& parent = numbered_[here.parent];
    const bool before = !plus_[here.low];
    expect(before || here.parent != 1, "nothing is inserted behind t");
    plus_[here.parent] = before;
    here.begin = before ? parent.begin : parent.end - here.size;
    here.end = here.begin + here.size;
    (before ? parent.begin : parent.end) = before ? here.end : here.begin;
  }
  for (Vertex i = 1; i < numbered_.size(); ++i) {
    expect(numbered_[i].begin + 1 == numbered_[i].end, "a vertex has one place");
    list_[numbered_[i].begin] = visited_[i];
  }
}

namespace {

/// Case c: y is adjacent to both of m and not to z.
bool repair_around(const LocalGraph& graph, Vertex* last, Vertex p5, Vertex y,
                   std::pair<Vertex, Vertex> m, Vertex z) {
  Vertex first = y;
  Vertex end = z;
  if (!graph.adjacent(p5, z)) {
    if (!graph.adjacent(p5, y)) return false;
    std::swap(first, end);
  } else if (graph.adjacent(p5, y)) {
    return false;
  }
  last[0] = first;
  last[1] = m.first;
  last[2] = m.second;
  last[3] = end;
  return true;
}

}  // namespace

bool repair_true_sink(const LocalGraph& graph, LongVector<Vertex>& list) {
  if (list.size() < 6) return false;
  Vertex* last = list.data() + list.size() - 4;
  const Vertex y = last[0];
  const std::pair<Vertex, Vertex> wc{last[1], last[2]};
  const Vertex t = last[3];
  const bool meets_c = graph.adjacent(wc.first, wc.second);
  if (!meets_c || !graph.adjacent(wc.first, t)) {  // case a: w has one later neighbour
    if (meets_c) std::swap(last[2], last[3]);
    return true;
  }
  const Vertex triangle[3] = {wc.first, wc.second, t};
  unsigned hits = 0;
  std::size_t hit = 0;
  std::size_t miss = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (graph.adjacent(y, triangle[i])) {
      ++hits;
      hit = i;
    } else {
      miss = i;
    }
  }
  if (hits == 1) {  // case b: the vertex adjacent to y goes last
    last[1] = triangle[(hit + 1) % 3];
    last[2] = triangle[(hit + 2) % 3];
    last[3] = triangle[hit];
    return true;
  }
  if (hits != 2) return false;
  return repair_around(graph, last, last[-1], y,
                       {triangle[(miss + 1) % 3], triangle[(miss + 2) % 3]}, triangle[miss]);
}

unsigned count_closing_neighbours(const LocalGraph& graph, const LongVector<Vertex>& list) {
  const Vertex t = list.back();
  const NeighbourList& near = graph.neighbours[t];
  unsigned count = 0;
  for (std::size_t k = 0; k < near.degree(); ++k) {
    const auto at = std::find(list.rbegin(), list.rend(), near.to[k]);
    if (at == list.rend()) continue;
    const auto is_later = [&](Vertex v) { return std::find(list.rbegin(), at, v) != at; };
    unsigned later = 0;
    const NeighbourList& other = graph.neighbours[*at];
    for (std::size_t j = 0; j < other.degree(); ++j) later += is_later(other.to[j]) ? 1u : 0u;
    if (later == 1) ++count;
  }
  return count;
}

}  // namespace ar3d::two_bend
