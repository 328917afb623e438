// Steps 2.2 to 2.5: the root, the walk over the tree of blocks, and both ends of a cubic bridgeless
// component. An st-order leaves at most one SOURCE, and one SINK per leaf block; the repairs give
// these the neighbours that their triples need. Cost: O(n).
#include "ar3d/algorithms/two_bend/time_order.h"

#include <algorithm>
#include <optional>

#include "ar3d/algorithms/two_bend/st_order.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

/// Lists of blocks, each from its entry.
class BlockLists {
 public:
  BlockLists(const LocalGraph& graph, const Blocks& blocks)
      : graph_(graph), blocks_(blocks), st_(graph, blocks) {}

  /// The block of s from s on, so that its last vertex has degree 2 inside the block if any but s
  /// has, and is a repaired true sink otherwise (Step 2.4: the block then has at least 7 vertices
  /// and a bridge at most at s).
  LongVector<Vertex> from(Vertex s) {
    const Block& block = blocks_.block_of(s);
    if (block.size == 1) return {s};
    for (std::size_t k = 0; k < std::min<std::size_t>(block.free_count, 2); ++k) {
      if (block.free[k] != s) return st_.order(s, block.free[k]);
    }
    LongVector<Vertex> list = st_.order(s, block.members[block.members[0] == s ? 1 : 0]);
    expect(list.size() >= 7 && repair_true_sink(graph_, list),
           "a true sink of a leaf block can be repaired");
    return list;
  }

  /// The st-order of a cubic block with both ends repaired (Step 2.5); nothing if a repair does not
  /// apply.
  std::optional<LongVector<Vertex>> with_both_ends(Vertex s, Vertex t) {
    LongVector<Vertex> list = st_.order(s, t);
    const bool top = repair_true_sink(graph_, list);
    std::reverse(list.begin(), list.end());
    const bool bottom = repair_true_sink(graph_, list);
    std::reverse(list.begin(), list.end());
    if (!top || !bottom) return std::nullopt;
    return list;
  }

 private:
  const LocalGraph& graph_;
  const Blocks& blocks_;
  StOrder st_;
};

/// Vertices in breadth-first order from `start`.
LongVector<Vertex> breadth_first(const LocalGraph& graph, Vertex start) {
  std::vector<bool> seen(graph.size(), false);
  LongVector<Vertex> queue{start};
  seen[start] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (i + kAhead < queue.size()) ask_for(graph.neighbours, queue[i + kAhead]);
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
LongVector<Vertex> order_of_cubic_block(const LocalGraph& graph, BlockLists& lists) {
  if (graph.size() >= 10) {
    auto list = lists.with_both_ends(0, breadth_first(graph, 0).back());
    expect(list.has_value(),
           "both ends of a cubic block with at least 10 vertices can be repaired");
    return *std::move(list);
  }
  for (Vertex s = 0; s < graph.size(); ++s) {
    const LongVector<Vertex> far = breadth_first(graph, s);
    for (std::size_t i = far.size(); i-- > 1;) {
      auto list = lists.with_both_ends(s, far[i]);
      if (list && both_ends_closed(graph, *list)) return *std::move(list);
    }
  }
  throw InternalError(
      "internal error: a cubic graph with 6 or 8 vertices has no repaired st-order");
}

/// A walk over the block tree that emits a block's list and, after each vertex, what hangs on its
/// bridges (Step 2.3).
class BlockTreeWalk {
 public:
  BlockTreeWalk(const LocalGraph& graph, const Blocks& blocks, BlockLists& lists)
      : graph_(graph), blocks_(blocks), lists_(lists), emitted_(graph.size(), false) {}

  LongVector<Vertex> from(const LongVector<Vertex>& first_block) {
    push(first_block);
    while (!frames_.empty()) step();
    return std::move(order_);
  }

 private:
  struct Frame {
    std::size_t begin;       // of the block's list in pending_
    std::size_t next;        // the next vertex of the list to emit
    std::uint8_t looked_at;  // half-edges of the last emitted vertex looked at so far
  };

  void push(const LongVector<Vertex>& list) {
    frames_.push_back({pending_.size(), pending_.size(), 0});
    pending_.insert(pending_.end(), list.begin(), list.end());
    ends_.push_back(pending_.size());
    emit_next(frames_.back());
  }

  void emit_next(Frame& frame) {
    const Vertex v = pending_[frame.next++];
    frame.looked_at = 0;
    emitted_[v] = true;
    order_.push_back(v);
  }

  void step() {
    Frame& frame = frames_.back();
    const Vertex v = pending_[frame.next - 1];
    const NeighbourList& near = graph_.neighbours[v];
    while (frame.looked_at < near.degree()) {
      const Vertex u = near.to[frame.looked_at++];
      if (blocks_.is_bridge(v, u) && !emitted_[u]) {
        push(lists_.from(u));
        return;
      }
    }
    if (frame.next < ends_.back()) {
      emit_next(frame);
    } else {
      pending_.resize(frame.begin);
      frames_.pop_back();
      ends_.pop_back();
    }
  }

  const LocalGraph& graph_;
  const Blocks& blocks_;
  BlockLists& lists_;
  std::vector<bool> emitted_;
  LongVector<Vertex> order_;
  LongVector<Vertex> pending_;
  LongVector<Frame> frames_;
  LongVector<std::size_t> ends_;
};

/// A vertex of degree 1, else of degree 2, that is still there.
std::optional<Vertex> root_of_low_degree(const LocalGraph& graph, const Blocks& blocks) {
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

TimeOrder find_time_order(const LocalGraph& graph, const Blocks& blocks) {
  BlockLists lists(graph, blocks);
  if (const auto root = root_of_low_degree(graph, blocks)) {
    return {BlockTreeWalk(graph, blocks, lists).from(lists.from(*root)), false};
  }
  const auto leaf =
      std::find_if(blocks.blocks.begin(), blocks.blocks.end(),
                   [](const Block& block) { return block.size > 1 && block.bridges == 1; });
  if (leaf == blocks.blocks.end()) return {order_of_cubic_block(graph, lists), true};
  LongVector<Vertex> first =
      lists.from(leaf->bridge_vertex);  // upside down: it begins with a SOURCE
  std::reverse(first.begin(), first.end());
  return {BlockTreeWalk(graph, blocks, lists).from(first), false};
}

}  // namespace ar3d::two_bend
