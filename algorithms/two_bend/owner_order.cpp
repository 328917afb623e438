#include "ar3d/algorithms/two_bend/owner_order.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ar3d/algorithms/two_bend/root_order.h"
#include "ar3d/model/error.h"

namespace ar3d::two_bend {

Unit unit_of(const View& view, const Pole& pole) {
  const auto all = view.outs(pole.node);
  if (pole.special == kNone) return {all[0], all[1], all[2], false};
  const auto [first, second] = view.ordinary_of(pole);
  if (!pole.a_type) return {first, second, pole.special, false};
  if (view.flow().adjacent_poles(pole)) return {first, second, kNone, false};
  if (view.is_special_split(first) || view.is_special_split(second))
    return {first, second, kNone, true};
  return {first, second, pole.node, false};
}

Attachment attach_merges(const View& view) {
  std::vector<bool> flagged(view.size(), false);
  for (const Pole& pole : view.flow().poles) {
    if (view.type(pole.node) != NodeType::source) continue;
    const Unit unit = unit_of(view, pole);
    for (const NodeId member : {unit.first, unit.second, unit.third}) {
      if (member != kNone) flagged[member] = true;
    }
  }
  const auto reluctance = [&](NodeId u) {
    return (view.is_special_split(u) ? 4 : 0) + (flagged[u] ? 2 : 0) +
           (view.type(u) == NodeType::merge ? 1 : 0);
  };
  Attachment attachment(view.size(), kNone);
  for (NodeId i = 0; i < view.size(); ++i) {
    const NodeId m = view.at(i);
    if (!view.is_listed_merge(m)) continue;
    const auto below = view.ins(m);
    const NodeId chosen = reluctance(below[0]) <= reluctance(below[1]) ? below[0] : below[1];
    expect(!view.is_special_split(chosen), "nothing is attached to the special SPLIT of a SINK");
    attachment[m] = view.row_of(chosen);
    flagged[m] = flagged[chosen];
  }
  return attachment;
}

namespace {

/// The forest of 4.1, step 2: SPLIT and STATION below a SPLIT; weights; trees hung elsewhere.
class Forest {
 public:
  Forest(const View& view, const Attachment& attachment)
      : view_(view), attachment_(attachment), cells_(view.size()) {
    find_parents();
    for (const Pole& pole : view.flow().poles) {
      if (view.type(pole.node) == NodeType::sink && !view.flow().joint) mark_hanging_block(pole);
    }
    hang_trees();
    weigh();
  }

  std::vector<NodeId> emit(bool straighten) {
    for (const Pole& pole : view_.flow().poles) {
      if (view_.type(pole.node) != NodeType::source) continue;
      const Unit unit = unit_of(view_, pole);
      if (unit.third_first) order_.push_back(pole.node);
    }
    const RootOrder roots = order_roots(straighten);
    for (NodeId v = roots.first(); v != kNone; v = roots.next(v)) {
      if (view_.type(v) == NodeType::source) {
        emit_unit(unit_of(view_, view_.pole(v)));
      } else {
        emit_trees({{v, Work::tree_on_right}});
      }
    }
    return std::move(order_);
  }

 private:
  struct Cell {
    NodeId parent = kNone;
    NodeId hangs_on = kNone;
    NodeId hung_first = kNone;  // list of the trees hung on it
    NodeId hung_next = kNone;
    std::uint32_t weight = 0;
  };
  struct Work {
    enum Kind { node, tree_on_right, tree_on_left };  // of its parent
    NodeId v;
    Kind kind;
  };

  bool is_root(NodeId v) const {
    return view_.type(v) == NodeType::source ||
           (is_initial_owner(v) && cells_[v].parent == kNone && cells_[v].hangs_on == kNone);
  }

  /// Roots in time order; if `straighten`, a SPLIT above a MERGE between the trees of the MERGE's
  /// in-neighbours if these differ: then the MERGE can have the SPLIT's row (see choose_vv_values).
  RootOrder order_roots(bool straighten) {
    RootOrder roots(view_.size());
    std::vector<NodeId> root(view_.size(), kNone);
    for (NodeId i = 0; i < view_.size(); ++i) {
      const NodeId v = view_.at(i);
      if (is_root(v)) {
        root[v] = v;
        if (!straighten || !place_above_merge(roots, root, v)) roots.append(v);
      } else {
        const NodeId to = below_in_tree(v);
        if (to != kNone) root[v] = root[to];
      }
    }
    return roots;
  }

  bool place_above_merge(RootOrder& roots, const std::vector<NodeId>& root, NodeId v) const {
    if (view_.type(v) != NodeType::split || view_.ins(v).empty()) return false;
    const NodeId m = view_.ins(v)[0];
    if (view_.type(m) != NodeType::merge) return false;
    const NodeId a = root[view_.row_of(view_.ins(m)[0])];
    const NodeId b = root[view_.row_of(view_.ins(m)[1])];
    if (a == b) return false;
    const NodeId lower = roots.before(a, b) ? a : b;
    // A pole's block keeps its rows together.
    if (view_.flow().in_pole_block(v) || view_.flow().in_pole_block(lower)) return false;
    roots.insert_after(lower, v);
    return true;
  }

  /// SINK rows are put into the list later, the SOURCE's is its unit's business.
  bool is_initial_owner(NodeId v) const {
    const NodeType type = view_.type(v);
    return type != NodeType::sink && type != NodeType::source && view_.is_owner(v);
  }

  void find_parents() {
    for (NodeId v = 0; v < view_.size(); ++v) {
      const NodeType type = view_.type(v);
      if ((type != NodeType::split && type != NodeType::station) || view_.ins(v).empty()) continue;
      const NodeId u = view_.ins(v)[0];
      const NodeType below = view_.type(u);
      if (below == NodeType::split || below == NodeType::source) cells_[v].parent = view_.row_of(u);
    }
  }

  /// R11: the roots of a SINK's block other than its entry e are emitted with e's tree, if e has a
  /// parent.
  void mark_hanging_block(const Pole& sink) {
    const Flow& flow = view_.flow();
    const BlockId block = flow.block[sink.node];
    const NodeId entry = flow.block_entry[block];
    if (entry == kNone || cells_[entry].parent == kNone) return;
    if (hang_block_.empty()) hang_block_.assign(flow.block_entry.size(), kNone);
    hang_block_[block] = entry;
  }

  void hang_trees() {
    if (hang_block_.empty()) return;
    for (NodeId i = view_.size(); i-- > 0;) {
      const NodeId v = view_.at(i);
      const NodeId entry = hang_block_[view_.flow().block[v]];
      if (entry == kNone || entry == v || !is_initial_owner(v) || cells_[v].parent != kNone)
        continue;
      cells_[v].hangs_on = entry;
      cells_[v].hung_next = std::exchange(cells_[entry].hung_first, v);
    }
  }

  void weigh() {
    for (NodeId i = view_.size();
         i-- > 0;) {  // attachments go back in time, so clusters add up to their owners
      const NodeId v = view_.at(i);
      ++cells_[v].weight;
      const NodeId to = below_in_tree(v);
      if (to != kNone) cells_[to].weight += cells_[v].weight;
    }
  }

  NodeId below_in_tree(NodeId v) const {
    return attachment_[v] != kNone ? attachment_[v] : tree_above(v);
  }

  NodeId tree_above(NodeId v) const {
    return cells_[v].parent != kNone ? cells_[v].parent : cells_[v].hangs_on;
  }

  struct Children {
    std::array<NodeId, kMostSharers + 1> of{};
    std::size_t count = 0;
  };
  /// The children in the forest of all that stand in the row of a SPLIT or STATION, the heaviest
  /// last.
  Children children(NodeId owner) const {
    Children result;
    add_children(owner, owner, result);
    std::sort(result.of.begin(), result.of.begin() + result.count,
              [&](NodeId a, NodeId b) { return cells_[a].weight < cells_[b].weight; });
    return result;
  }

  void add_children(NodeId v, NodeId owner, Children& result) const {
    for (const NodeId w : view_.outs(v)) {
      if (cells_[w].parent != owner) continue;
      if (view_.row_of(w) == owner) {
        add_children(w, owner, result);
      } else {
        result.of[result.count++] = w;
      }
    }
  }

  /// The unit's members side by side; the children of the first to the left, all others to the
  /// right.
  void emit_unit(const Unit& unit) {
    std::vector<Work> left;
    const Children first = children(unit.first);
    for (std::size_t i = first.count; i-- > 0;) left.push_back({first.of[i], Work::tree_on_left});
    emit_trees(left);  // light one nearest
    std::vector<Work> right;
    for (const NodeId member : {unit.second, unit.third}) {
      if (member == kNone || view_.type(member) != NodeType::split) continue;
      const Children below = children(member);
      for (std::size_t i = 0; i < below.count; ++i)
        right.push_back({below.of[i], Work::tree_on_right});
    }
    for (const NodeId member : {unit.first, unit.second, unit.third}) {
      if (member != kNone) order_.push_back(member);
    }
    emit_trees(right);
  }

  /// Emits trees from left to right with an explicit stack.
  void emit_trees(const std::vector<Work>& trees) {
    stack_.assign(trees.rbegin(), trees.rend());
    while (!stack_.empty()) {
      const Work work = stack_.back();
      stack_.pop_back();
      if (work.kind == Work::node) {
        order_.push_back(work.v);
      } else {
        push_parts(work.v, work.kind);
      }
    }
  }

  /// [light ones] v [heavy] [hung trees], going away from the parent; `away` is the kind of trees
  /// beyond v.
  void push_parts(NodeId v, Work::Kind away) {
    const bool to_right = away == Work::tree_on_right;
    const std::size_t begin = stack_.size();
    const Children below = children(v);
    for (std::size_t i = below.count; i-- > 0;) {
      if (i + 1 < below.count)
        stack_.push_back({below.of[i], to_right ? Work::tree_on_left : Work::tree_on_right});
    }
    stack_.push_back({v, Work::node});
    if (below.count > 0) stack_.push_back({below.of[below.count - 1], away});
    for (NodeId h = cells_[v].hung_first; h != kNone; h = cells_[h].hung_next)
      stack_.push_back({h, away});
    if (to_right) std::reverse(stack_.begin() + static_cast<std::ptrdiff_t>(begin), stack_.end());
  }

  const View& view_;
  const Attachment& attachment_;
  std::vector<Cell> cells_;
  std::vector<NodeId> hang_block_;  // per block: the entry its other roots hang on
  std::vector<Work> stack_;
  std::vector<NodeId> order_;
};

}  // namespace

std::vector<NodeId> order_owners(const View& view, const Attachment& attachment, bool straighten) {
  return Forest(view, attachment).emit(straighten);
}

}  // namespace ar3d::two_bend
