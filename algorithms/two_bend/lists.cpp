// Rule 2.8: SPLITs in the row of the SPLIT below them, which saves a bend and a row each. Whether
// two arms of a row can meet depends on the columns, whose order depends on the rows; so the first
// list shares by a guess and gives back what does not fit. Cost: O(n).
#include "ar3d/algorithms/two_bend/lists.h"

#include <algorithm>

namespace ar3d::two_bend {
namespace {

/// The columns that a SPLIT and those above it in its row reach.
struct RowReach {
  std::int32_t low = 0;
  std::int32_t high = 0;
  std::uint8_t sharers = 0;  ///< SPLITs
  std::uint8_t light = 0;    ///< SPLITs in the trees above the row's SPLITs except the heaviest
  std::uint8_t heaviest = 0;
  std::uint8_t tree = 0;  ///< SPLITs in the tree of a SPLIT above a SPLIT

  bool meets(const RowReach& other) const { return low <= other.high && other.low <= high; }
};

/// All trees above a row's SPLITs but the heaviest may have so many SPLITs; what has more counts as
/// one more.
constexpr std::uint8_t kMostLightWeight = 64;
constexpr std::uint8_t kTooHeavy = kMostLightWeight + 1;

/// Holds who shares the row of the SPLIT below it.
class Sharing {
 public:
  Sharing(const View& view, const Values& cross)
      : view_(view), cross_(cross), reach_(view.size()), left_alone_(view.size(), false) {
    for (const Pole& pole : view.flow().poles) {
      for (const NodeId v : view.flow().nodes[pole.node].neighbour) left_alone_[v] = true;
    }
  }

  /// From the top down the view's time, undoes what two arms of a SPLIT cannot both have.
  /// @param shares  per node: asks to stand in the row of the SPLIT below it.
  /// @param is_new  first lets all ask that may; also undoes what exceeds kMostSharers or
  /// kMostLightWeight.
  /// @return true if something was undone.
  bool undo_conflicts(LongVector<std::uint8_t>& shares, bool is_new) {
    bool changed = false;
    for (NodeId i = view_.size(); i-- > 0;) {
      const NodeId v = view_.at(i);
      view_.prefetch_neighbours(i - kAhead, reach_);
      view_.prefetch_neighbours(i - kAhead, cross_);
      if (view_.type(v) != NodeType::split) continue;
      NodeId a = view_.outs(v)[0];
      NodeId b = view_.outs(v)[1];
      if (is_new) {
        weigh_tree(v);
        for (const NodeId w : {a, b}) shares[w] = may_share(v, w);
      }
      if (shares[a] < shares[b]) std::swap(a, b);  // a single asker is a
      if (shares[a] && shares[b] && reach_[a].sharers < reach_[b].sharers) std::swap(a, b);
      RowReach pa = part(shares, a);
      RowReach pb = part(shares, b);
      const auto leave = [&](NodeId asker, RowReach& its) {
        if (!shares[asker] || fits(pa, pb, is_new)) return;
        shares[asker] = 0;
        its = part(shares, asker);
        changed = true;
      };
      leave(b, pb);  // the smaller part goes first
      leave(a, pa);
      const std::uint8_t tree = reach_[v].tree;
      reach_[v] = united(pa, pb);
      reach_[v].tree = tree;
    }
    return changed;
  }

 private:
  /// A SPLIT may stand in the row of the SPLIT below it: neighbours of a pole share nothing, nor do
  /// edges into or out of a pole's block.
  bool may_share(NodeId below, NodeId v) const {
    const Flow& flow = view_.flow();
    if (view_.type(v) != NodeType::split || left_alone_[below] || left_alone_[v]) return false;
    return flow.joint || flow.block[v] == flow.block[below] ||
           (!flow.in_pole_block(below) && !flow.in_pole_block(v));
  }
  RowReach part(const LongVector<std::uint8_t>& shares, NodeId v) const {
    if (shares[v]) return reach_[v];
    return {cross_[v], cross_[v], 0, 0, reach_[v].tree, reach_[v].tree};
  }
  static RowReach united(const RowReach& a, const RowReach& b) {
    const int light = a.light + b.light + std::min(a.heaviest, b.heaviest);
    return {std::min(a.low, b.low), std::max(a.high, b.high),
            static_cast<std::uint8_t>(a.sharers + b.sharers + 1),
            static_cast<std::uint8_t>(std::min<int>(light, kTooHeavy)),
            std::max(a.heaviest, b.heaviest)};
  }
  static bool fits(const RowReach& a, const RowReach& b, bool is_new) {
    const RowReach both = united(a, b);
    return !a.meets(b) &&
           (!is_new || (both.sharers <= kMostSharers && both.light <= kMostLightWeight));
  }

  /// SPLITs in the tree of a SPLIT that stands above a SPLIT, 0 for all others; those above it are
  /// weighed.
  void weigh_tree(NodeId v) {
    if (view_.ins(v).empty()) return;
    const NodeId u = view_.ins(v)[0];
    std::uint8_t& tree = reach_[v].tree;
    if (view_.type(u) != NodeType::split) {
      tree = 0;
      return;
    }
    ++tree;
    const auto most = static_cast<std::uint8_t>(std::min<NodeId>(view_.size(), kTooHeavy));
    if (view_.flow().in_pole_block(v) && !view_.flow().in_pole_block(u)) tree = most;
    reach_[u].tree = static_cast<std::uint8_t>(std::min<int>(reach_[u].tree + tree, most));
  }

  const View& view_;
  const Values& cross_;
  LongVector<RowReach> reach_;
  std::vector<bool> left_alone_;  // per node; small enough to stay in the cache
};

LongVector<NodeId>& owners_of(Flow& flow, bool columns) { return flow.row_owner[columns ? 1 : 0]; }

/// Sets the owners of rows from who shares; the lowest SPLIT of a row owns it. No MERGE may have
/// both in-neighbours in one row: the later of the two shall leave it.
/// @return true if one shall: then a second call changes the owners.
bool set_owners(Flow& flow, const View& view, LongVector<std::uint8_t>& shares) {
  LongVector<NodeId>& owner = owners_of(flow, view.columns());
  LongVector<std::uint8_t>& roles = flow.roles[view.columns() ? 1 : 0];
  bool changed = false;
  for (NodeId i = 0; i < view.size(); ++i) {
    const NodeId v = view.at(i);
    view.prefetch_neighbours(i + kAhead, owner);
    owner[v] = shares[v] ? owner[view.ins(v)[0]] : v;
    if (view.type(v) == NodeType::split) {
      roles[v] = static_cast<std::uint8_t>((roles[v] & ~(kOwner | kSharesRow)) |
                                           (shares[v] ? kSharesRow : kOwner));
      if (shares[v]) roles[owner[v]] |= kSharesRow;
    } else if (view.type(v) == NodeType::merge) {
      const NodeId a = view.ins(v)[0];
      const NodeId b = view.ins(v)[1];
      if (owner[a] != owner[b]) continue;
      shares[view.columns() ? std::min(a, b) : std::max(a, b)] = 0;
      changed = true;
    }
  }
  return changed;
}

LongVector<std::uint8_t> sharers(const View& view) {
  LongVector<std::uint8_t> shares(view.size(), 0);
  for (NodeId v = 0; v < view.size(); ++v) shares[v] = view.row_of(v) != v;
  return shares;
}

/// Puts SPLITs into the row of the SPLIT below them where that costs nothing: the edge between them
/// then has one bend instead of two, and the view one row fewer. A row's SPLITs form a subtree of
/// the forest of SPLITs; it is drawn without crossings in the plane of the row if at each of its
/// SPLITs the columns reached through one arm lie beyond all those reached through the other.
/// @param cross  columns of the view, or any guess of their order (then see separate_rows).
/// @post  flow.row_owner and the roles of the view; no MERGE has both in-neighbours in one row.
/// Cost: O(n).
void share_rows(Flow& flow, bool columns, const Values& cross) {
  const View view(flow, columns);
  LongVector<std::uint8_t> shares(view.size(), 0);
  Sharing(view, cross).undo_conflicts(shares, true);
  if (set_owners(flow, view, shares)) set_owners(flow, view, shares);
}

/// Gives SPLITs a row of their own again, next to the one they shared, until the condition of
/// share_rows holds for the columns `cross`. The order of all other entries stays as it is.
void separate_rows(Flow& flow, bool columns, const Values& cross, LongVector<NodeId>& list) {
  const View view(flow, columns);
  LongVector<std::uint8_t> shares = sharers(view);
  if (!Sharing(view, cross).undo_conflicts(shares, false)) return;
  const LongVector<NodeId> before = owners_of(flow, columns);
  set_owners(flow, view, shares);
  LongVector<NodeId> added(view.size(), kNone);  // a linked list behind every entry
  for (NodeId v = 0; v < view.size(); ++v) {
    if (!shares[v] && before[v] != v) added[v] = std::exchange(added[before[v]], v);
  }
  LongVector<NodeId> result;
  result.reserve(list.size());
  for (NodeId v : list) {
    for (; v != kNone; v = added[v]) result.push_back(v);
  }
  list = std::move(result);
}

/// A guess of the order of the view's rows before its list is built: the owners' indices, and next
/// to them the MERGEs.
Values guess_rows(const Flow& flow, bool columns) {
  const View view(flow, columns);
  const Attachment attachment = attach_merges(view);
  Values guess(view.size(), 0);
  std::int32_t index = 0;
  for (const NodeId owner : order_owners(view, attachment)) guess[owner] = index += 4;
  for (NodeId i = 0; i < view.size(); ++i) {
    const NodeId m = view.at(i);
    view.prefetch_neighbours(i + kAhead, guess);
    if (attachment[m] == kNone) continue;
    const NodeId other = view.ins(m)[view.ins(m)[0] == attachment[m] ? 1 : 0];
    guess[m] = guess[attachment[m]] + (guess[other] < guess[attachment[m]] ? -1 : 1);
  }
  return guess;
}

}  // namespace

bool shared_rows_are_plane(const View& view, const Values& cross) {
  LongVector<std::uint8_t> shares = sharers(view);
  return !Sharing(view, cross).undo_conflicts(shares, false);
}

Lists build_lists(Flow& flow, bool share, const TreeWeights& weights) {
  const bool columns_first =
      flow.joint && std::any_of(flow.poles.begin(), flow.poles.end(), [&](const Pole& p) {
        return flow.nodes[p.node].type == NodeType::source && p.a_type;
      });
  if (share) share_rows(flow, columns_first, guess_rows(flow, !columns_first));
  LongVector<NodeId> first = build_view_list(flow, columns_first, weights[columns_first ? 1 : 0]);
  choose_outer_specials(flow, !columns_first, first);
  if (share) share_rows(flow, !columns_first, list_indices(View(flow, columns_first), first));
  LongVector<NodeId> second = build_view_list(flow, !columns_first, weights[columns_first ? 0 : 1]);
  if (share) {
    separate_rows(flow, columns_first, list_indices(View(flow, !columns_first), second), first);
  }
  if (columns_first) std::swap(first, second);
  return {std::move(first), std::move(second)};
}

}  // namespace ar3d::two_bend
