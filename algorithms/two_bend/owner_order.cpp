// Rules 2.1 and 2.2: who stands next to whom, and the order of the rows before anything moves. The
// light child of a SPLIT lies on its parent's side and the heavy one away from it, so the leans of
// a tree cost no more than the square of its rows (Lemma 2.17). Cost: O(n).
#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <unordered_map>

#include "ar3d/algorithms/two_bend/lists.h"
#include "ar3d/base/error.h"

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
    view.prefetch_rows(i + kAhead);
    view.prefetch_types(i + kAhead);
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

/// The forest of Rule 2.2: SPLIT and STATION below a SPLIT; weights; trees hung elsewhere.
class Forest {
 public:
  Forest(const View& view, const Attachment& attachment, const LongVector<std::uint32_t>& weights)
      : view_(view),
        attachment_(attachment),
        trees_(view.size()),
        grows_right_(view.size(), false),
        order_(view.size(), kNone) {
    for (const Pole& pole : view.flow().poles) {
      if (view.type(pole.node) == NodeType::sink && !view.flow().joint) mark_hanging_block(pole);
    }
    hang_trees();
    weigh(weights);
  }

  /// Every tree fills consecutive indices of the order: in time order a root's indices are found,
  /// then within a tree's those of its parts, which are later.
  LongVector<NodeId> emit() {
    for (const Pole& pole : view_.flow().poles) {
      if (view_.type(pole.node) != NodeType::source) continue;
      const Unit unit = unit_of(view_, pole);
      if (unit.third_first) place_node(pole.node);
    }
    for (NodeId i = 0; i < view_.size(); ++i) {
      const NodeId v = view_.at(i);
      view_.prefetch_neighbours(i + kAhead, trees_);
      view_.prefetch_types(i + kAhead);
      if (view_.type(v) == NodeType::source) {
        place_unit(unit_of(view_, view_.pole(v)));
      } else if (is_initial_owner(v) && tree_above(v) == kNone) {
        place_tree(v, true);
      }
      if (trees_[v].begin != kNone) place_parts(v);
    }
    order_.resize(end_);
    return std::move(order_);
  }

 private:
  struct Tree {
    NodeId parent = kNone;
    std::uint32_t weight = 0;
    std::uint32_t size = 0;       // owners of the tree
    std::uint32_t begin = kNone;  // its first index in the order
  };

  /// SINK rows are put into the list later, the SOURCE's is its unit's business.
  bool is_initial_owner(NodeId v) const {
    const NodeType type = view_.type(v);
    return type != NodeType::sink && type != NodeType::source && view_.is_owner(v);
  }

  NodeId parent_of(NodeId v) const {
    const NodeType type = view_.type(v);
    if ((type != NodeType::split && type != NodeType::station) || view_.ins(v).empty())
      return kNone;
    const NodeId u = view_.ins(v)[0];
    const NodeType below = view_.type(u);
    return below == NodeType::split || below == NodeType::source ? view_.row_of(u) : kNone;
  }

  /// Rule 2.2: the roots of a SINK's block other than its entry e are emitted with e's tree, if e
  /// has a parent.
  void mark_hanging_block(const Pole& sink) {
    const Flow& flow = view_.flow();
    const BlockId block = flow.block[sink.node];
    const NodeId entry = flow.block_entry[block];
    if (entry == kNone || parent_of(entry) == kNone) return;
    if (hang_block_.empty()) hang_block_.assign(flow.block_entry.size(), kNone);
    hang_block_[block] = entry;
  }

  void hang_trees() {
    if (hang_block_.empty()) return;
    hangs_on_.assign(view_.size(), kNone);
    for (NodeId i = 0; i < view_.size(); ++i) {
      const NodeId v = view_.at(i);
      const NodeId entry = hang_block_[view_.flow().block[v]];
      if (entry == kNone || entry == v || !is_initial_owner(v) || parent_of(v) != kNone) continue;
      hangs_on_[v] = entry;
      hung_[entry].push_back(v);
    }
  }

  /// Attachments go back in time, so clusters add up to their owners.
  void weigh(const LongVector<std::uint32_t>& weights) {
    for (NodeId i = view_.size(); i-- > 0;) {
      const NodeId v = view_.at(i);
      view_.prefetch_rows(i - 2 * kAhead);
      if (i >= kAhead) find_parent(view_.at(i - kAhead));
      if (i + kAhead >= view_.size()) find_parent(v);
      Tree& tree = trees_[v];
      tree.weight += weights.empty() ? 1 : weights[v];
      if (is_initial_owner(v)) ++tree.size;
      const NodeId to = attachment_[v] != kNone ? attachment_[v] : tree_above(v);
      if (to == kNone) continue;
      trees_[to].weight += tree.weight;
      trees_[to].size += tree.size;
    }
  }

  /// Also prefetches what v is added to.
  void find_parent(NodeId v) {
    trees_[v].parent = parent_of(v);
    const NodeId to = attachment_[v] != kNone ? attachment_[v] : trees_[v].parent;
    if (to != kNone) prefetch(trees_, to);
  }

  NodeId tree_above(NodeId v) const {
    return trees_[v].parent != kNone || hangs_on_.empty() ? trees_[v].parent : hangs_on_[v];
  }

  using Children = boost::container::static_vector<NodeId, kMostSharers + 1>;
  /// The children in the forest of all that stand in the row of a SPLIT or STATION, the heaviest
  /// last.
  Children children(NodeId owner) const {
    Children result;
    add_children(owner, owner, result);
    std::sort(result.begin(), result.end(),
              [&](NodeId a, NodeId b) { return trees_[a].weight < trees_[b].weight; });
    return result;
  }

  /// Above a STATION, and above a START that owns a row, stands neither SPLIT nor STATION.
  void add_children(NodeId v, NodeId owner, Children& result) const {
    for (const NodeId w : view_.outs(v)) {
      const NodeType type = view_.type(w);
      if (type != NodeType::split && type != NodeType::station) continue;
      if (!view_.is_owner(w)) {  // it shares the row
        add_children(w, owner, result);
      } else {
        result.push_back(w);
      }
    }
  }

  void place_node(NodeId v) { order_[end_++] = v; }

  /// The next indices for the whole tree of v, which grows to the right or to the left.
  void place_tree(NodeId v, bool to_right) {
    trees_[v].begin = end_;
    grows_right_[v] = to_right;
    end_ += trees_[v].size;
  }

  /// The unit's members side by side; the children of the first to the left, all others to the
  /// right, light ones nearest.
  void place_unit(const Unit& unit) {
    const Children first = children(unit.first);
    for (std::size_t i = first.size(); i-- > 0;) place_tree(first[i], false);
    for (const NodeId member : {unit.first, unit.second, unit.third}) {
      if (member != kNone) place_node(member);
    }
    for (const NodeId member : {unit.second, unit.third}) {
      if (member == kNone || view_.type(member) != NodeType::split) continue;
      for (const NodeId child : children(member)) place_tree(child, true);
    }
  }

  /// [light ones] v [heavy] [hung trees] in the indices of the tree of v, going away from its
  /// parent.
  void place_parts(NodeId v) {
    const bool to_right = grows_right_[v];
    std::uint32_t at = trees_[v].begin + (to_right ? 0 : trees_[v].size);
    const auto take = [&](std::uint32_t size) {
      if (to_right) return std::exchange(at, at + size);
      return at -= size;
    };
    const auto place = [&](NodeId tree, bool away) {
      trees_[tree].begin = take(trees_[tree].size);
      grows_right_[tree] = away == to_right;
    };
    const Children above = children(v);
    for (std::size_t i = above.size(); i-- > 1;) place(above[i - 1], false);
    order_[take(1)] = v;
    if (!above.empty()) place(above.back(), true);
    const auto hung = hung_.find(v);
    if (hung == hung_.end()) return;
    for (const NodeId tree : hung->second) place(tree, true);
  }

  const View& view_;
  const Attachment& attachment_;
  LongVector<Tree> trees_;
  LongVector<NodeId> hang_block_;  // per block: the entry its other roots hang on
  LongVector<NodeId> hangs_on_;    // per node; empty if no tree hangs
  std::unordered_map<NodeId, std::vector<NodeId>> hung_;  // per entry that trees hang on
  std::vector<bool> grows_right_;                         // per root of a tree
  LongVector<NodeId> order_;
  std::uint32_t end_ = 0;  // of the indices taken
};

}  // namespace

LongVector<NodeId> order_owners(const View& view, const Attachment& attachment,
                                const LongVector<std::uint32_t>& weights) {
  return Forest(view, attachment, weights).emit();
}

}  // namespace ar3d::two_bend
