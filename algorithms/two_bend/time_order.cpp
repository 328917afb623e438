// Steps 2.2 to 2.5: the root, the walk over the tree of blocks, Tarjan's st-order of each block from
// its lowpoints, by sizes of subtrees instead of a linked list, and both ends of a cubic bridgeless
// component. An st-order leaves at most one SOURCE, and one SINK per leaf block; the repairs, which
// are this project's, give these the neighbours that their triples need. Cost: O(n).
#include "ar3d/algorithms/two_bend/time_order.h"

#include <algorithm>
#include <optional>

#include "ar3d/base/error.h"

namespace ar3d::two_bend {

StOrder::StOrder(const LocalGraph& graph, const BlockTree& blocks)
    : graph_(graph), blocks_(blocks), seen_(graph.size(), false), number_(graph.size()) {
  numbered_.reserve(graph.size());
  turns_.reserve(graph.size());
}

LongVector<Vertex> StOrder::order(Vertex s, Vertex t) {
  expect(s != t && !blocks_.is_bridge(s, t), "an st-order runs between two vertices of one block");
  search(s, t);
  find_lows();
  for (const Numbered& each : numbered_) seen_[each.vertex] = false;
  return place_in_preorder();
}

/// Depth-first search of the block from t, with the virtual tree edge s - t above it.
void StOrder::search(Vertex s, Vertex t) {
  numbered_.assign(1, {.vertex = s});
  seen_[s] = true;
  number_[s] = 0;
  turns_.assign(1, {t, Vertex{0}});
  while (!turns_.empty()) {
    const auto [v, parent] = turns_.back();
    turns_.pop_back();
    if (!seen_[v]) visit(v, parent);
  }
}

/// Neighbours seen before lie on the way back to s; low is the least of their numbers but the
/// parent's. Nothing waits for a number: the search goes on while they come.
void StOrder::visit(Vertex v, Vertex parent) {
  const auto number = static_cast<Vertex>(numbered_.size());
  seen_[v] = true;
  number_[v] = number;
  Vertex low = number;
  const NeighbourList& near = graph_.neighbours[v];
  for (std::size_t k = near.degree(); k-- > 0;) {
    const Vertex u = near.to[k];
    if (blocks_.is_bridge(v, u)) continue;
    if (!seen_[u]) {
      prefetch(graph_.neighbours, u);
      turns_.push_back({u, number});
    } else if (number_[u] != parent) {
      low = std::min(low, number_[u]);
    }
  }
  numbered_.push_back({.vertex = v, .parent = parent, .low = low});
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
LongVector<Vertex> StOrder::place_in_preorder() {
  LongVector<Vertex> list(numbered_.size());
  list[0] = numbered_[0].vertex;
  plus_.assign(numbered_.size(), false);
  numbered_[1].low = 1;
  numbered_[1].size = static_cast<std::uint32_t>(numbered_.size());
  for (Vertex i = 2; i < numbered_.size(); ++i) {
    Numbered& here = numbered_[i];
    auto& [vertex, above, begin, end] = numbered_[here.parent];
    const bool before = !plus_[here.low];
    expect(before || here.parent != 1, "nothing is inserted behind t");
    plus_[here.parent] = before;
    here.low = before ? begin : end - here.size;
    here.size += here.low;
    (before ? begin : end) = before ? here.size : here.low;
  }
  for (Vertex i = 1; i < numbered_.size(); ++i) {
    const auto [vertex, parent, begin, end] = numbered_[i];
    expect(begin + 1 == end, "a vertex has one index");
    list[begin] = vertex;
  }
  return list;
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

/// The block of s from s on, so that its last vertex has degree 2 inside the block if any but s
/// has, and is a repaired true sink otherwise (Step 2.4: the block then has at least 7 vertices and
/// a bridge at most at s).
LongVector<Vertex> block_list(const LocalGraph& graph, const BlockTree& blocks, StOrder& st,
                              Vertex s) {
  const Block& block = blocks.block_of(s);
  if (block.size == 1) return {s};
  for (std::size_t k = 0; k < std::min<std::size_t>(block.free_count, 2); ++k) {
    if (block.free[k] != s) return st.order(s, block.free[k]);
  }
  LongVector<Vertex> list = st.order(s, block.members[block.members[0] == s ? 1 : 0]);
  expect(list.size() >= 7 && repair_true_sink(graph, list),
         "a true sink of a leaf block can be repaired");
  return list;
}

/// The st-order of a cubic block with both ends repaired (Step 2.5); nothing if a repair does not
/// apply.
std::optional<LongVector<Vertex>> list_with_both_ends(const LocalGraph& graph, StOrder& st,
                                                      Vertex s, Vertex t) {
  LongVector<Vertex> list = st.order(s, t);
  const bool top = repair_true_sink(graph, list);
  std::reverse(list.begin(), list.end());
  const bool bottom = repair_true_sink(graph, list);
  std::reverse(list.begin(), list.end());
  if (!top || !bottom) return std::nullopt;
  return list;
}

/// Vertices in breadth-first order from `start`.
LongVector<Vertex> breadth_first(const LocalGraph& graph, Vertex start) {
  std::vector<bool> seen(graph.size(), false);
  LongVector<Vertex> queue;
  queue.reserve(graph.size());
  queue.push_back(start);
  seen[start] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (i + kAhead < queue.size()) prefetch(graph.neighbours, queue[i + kAhead]);
    const NeighbourList& near = graph.neighbours[queue[i]];
    for (std::size_t k = 0; k < near.degree(); ++k) {
      if (!seen[near.to[k]]) {
        seen[near.to[k]] = true;
        queue.push_back(near.to[k]);
      }
    }
  }
  return queue;
}

bool both_ends_closed(const LocalGraph& graph, LongVector<Vertex> list) {
  if (count_closing_neighbours(graph, list) < 2) return false;
  std::reverse(list.begin(), list.end());
  return count_closing_neighbours(graph, list) >= 2;
}

/// Step 2.5: a cubic bridgeless component. From 10 vertices on any pair works; the six smaller
/// graphs are searched.
LongVector<Vertex> order_of_cubic_block(const LocalGraph& graph, StOrder& st) {
  if (graph.size() >= 10) {
    auto list = list_with_both_ends(graph, st, 0, breadth_first(graph, 0).back());
    expect(list.has_value(),
           "both ends of a cubic block with at least 10 vertices can be repaired");
    return *std::move(list);
  }
  for (Vertex s = 0; s < graph.size(); ++s) {
    const LongVector<Vertex> far = breadth_first(graph, s);
    for (std::size_t i = far.size(); i-- > 1;) {
      auto list = list_with_both_ends(graph, st, s, far[i]);
      if (list && both_ends_closed(graph, *list)) return *std::move(list);
    }
  }
  throw InternalError(
      "internal error: a cubic graph with 6 or 8 vertices has no repaired st-order");
}

/// A block on the way of walk_block_tree.
struct OpenBlock {
  std::size_t begin;           // of the block's list among all pending ones
  std::size_t end;             // of it
  std::size_t next;            // the next vertex of the list to emit
  std::uint8_t looked_at = 0;  // half-edges of the last emitted vertex looked at so far
};

/// A walk over the block tree that emits a block's list and, after each vertex, what hangs on its
/// bridges (Step 2.3).
LongVector<Vertex> walk_block_tree(const LocalGraph& graph, const BlockTree& blocks, StOrder& st,
                                   const LongVector<Vertex>& first_block) {
  std::vector<bool> emitted(graph.size(), false);
  LongVector<Vertex> order;
  LongVector<Vertex> pending;
  LongVector<OpenBlock> open;
  const auto emit_next = [&](OpenBlock& block) {
    const Vertex v = pending[block.next++];
    block.looked_at = 0;
    emitted[v] = true;
    order.push_back(v);
  };
  const auto enter = [&](const LongVector<Vertex>& list) {
    open.push_back({pending.size(), pending.size() + list.size(), pending.size()});
    pending.insert(pending.end(), list.begin(), list.end());
    emit_next(open.back());
  };
  for (enter(first_block); !open.empty();) {
    OpenBlock& block = open.back();
    const Vertex v = pending[block.next - 1];
    const NeighbourList& near = graph.neighbours[v];
    if (block.looked_at < near.degree()) {
      const Vertex u = near.to[block.looked_at++];
      if (blocks.is_bridge(v, u) && !emitted[u]) enter(block_list(graph, blocks, st, u));
    } else if (block.next < block.end) {
      emit_next(block);
    } else {
      pending.resize(block.begin);
      open.pop_back();
    }
  }
  return order;
}

/// A vertex of degree 1, else of degree 2, that is still there.
std::optional<Vertex> root_of_low_degree(const LocalGraph& graph, const BlockTree& blocks) {
  std::optional<Vertex> found;
  for (Vertex v = 0; v < graph.size(); ++v) {
    const std::size_t degree = graph.neighbours[v].degree();
    const Block& block = blocks.block_of(v);
    if (block.size == 1 && block.members[0] != v) continue;  // cut off with its Q body
    if (degree == 1) return v;
    if (degree == 2 && !found) found = v;
  }
  return found;
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

TimeOrder find_time_order(const LocalGraph& graph, const BlockTree& blocks) {
  StOrder st(graph, blocks);
  if (const auto root = root_of_low_degree(graph, blocks)) {
    return {walk_block_tree(graph, blocks, st, block_list(graph, blocks, st, *root)), false};
  }
  const auto leaf =
      std::find_if(blocks.blocks.begin(), blocks.blocks.end(),
                   [](const Block& block) { return block.size > 1 && block.bridges == 1; });
  if (leaf == blocks.blocks.end()) return {order_of_cubic_block(graph, st), true};
  // Upside down: it begins with a SOURCE.
  LongVector<Vertex> first = block_list(graph, blocks, st, leaf->bridge_vertex);
  std::reverse(first.begin(), first.end());
  return {walk_block_tree(graph, blocks, st, first), false};
}

}  // namespace ar3d::two_bend
