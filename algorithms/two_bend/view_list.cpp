// Rules 2.3 and 2.4: MERGEs are inserted between their in-neighbours, and the row of a SINK's
// special edge between its two other neighbours (Lemma 2.7); what depends on that row waits until
// the SINK's turn. Order tests need no balanced tree: what is put next to an owner stays in its
// cluster, clusters keep their ranks, and inside one a short walk decides.
// Cost: O(n), an insertion being O(1), amortised.
#include <algorithm>
#include <array>
#include <utility>

#include "ar3d/algorithms/two_bend/coordinates.h"
#include "ar3d/algorithms/two_bend/lists.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

constexpr std::size_t kWalkers = 16;

using Pair = std::array<NodeId, 2>;

/// A SINK's ordinary neighbours, and what had to wait for them (Rule 2.4).
struct WaitingSink {
  NodeId c = kNone;
  NodeId w = kNone;
  LongVector<NodeId> chain;  ///< MERGEs above the special SPLIT, upwards
  bool reaches_c = false;    ///< the chain runs into c
};

class ListBuilder {
 public:
  ListBuilder(Flow& flow, bool columns, const LongVector<std::uint32_t>& weights)
      : view_(flow, columns),
        poles_(flow.poles),
        attachment_(attach_merges(view_)),
        list_(view_.size(), order_owners(view_, attachment_, weights)),
        postponed_(view_.size(), false) {}

  LongVector<NodeId> build() {
    for (const Pole& pole : poles_) {
      if (view_.type(pole.node) == NodeType::sink && pole.special != kNone)
        postpone(waiting_for(pole));
    }
    for (NodeId i = 0; i < view_.size(); ++i) {
      const NodeId v = view_.at(i);
      prefetch_ahead(i);
      if (view_.type(v) == NodeType::sink) {
        place_sink(poles_[view_.flow().pole_of(v)]);
      } else if (view_.is_listed_merge(v) && !postponed_[v]) {
        insert_attached(v);
      }
    }
    return list_.in_order();
  }

 private:
  /// Prefetches, in two steps, the entries that the MERGEs soon after i are put between.
  [[gnu::always_inline]] void prefetch_ahead(NodeId i) const {
    view_.prefetch_rows(i + 2 * kAhead);
    if (i + kAhead >= view_.size()) return;
    const NodeId v = view_.at(i + kAhead);
    if (!view_.is_listed_merge(v)) return;
    list_.prefetch_entry(v);
    for (const NodeId u : view_.ins(v)) list_.prefetch_entry(view_.row_of(u));
  }

  WaitingSink waiting_for(const Pole& pole) const {
    WaitingSink result;
    const Pair ordinary = view_.ordinary_of(pole);
    result.c = ordinary[0];
    result.w = ordinary[1];
    if (view_.type(pole.special) != NodeType::split) return result;
    const auto above = view_.outs(pole.special);
    NodeId b = above[0] == pole.node ? above[1] : above[0];
    while (b != result.c && b != result.w && view_.type(b) == NodeType::merge) {
      result.chain.push_back(b);
      if (view_.outs(b).empty()) return result;
      b = view_.outs(b)[0];
    }
    if (b == result.w) std::swap(result.c, result.w);
    result.reaches_c = b == result.c;
    return result;
  }

  void postpone(const WaitingSink& sink) {
    postponed_[sink.c] = postponed_[sink.w] = true;
    for (const NodeId b : sink.chain) postponed_[b] = true;
  }

  Pair sorted(NodeId a, NodeId b) const { return list_.before(b, a) ? Pair{b, a} : Pair{a, b}; }
  Pair row_ins(NodeId m) const {
    return {view_.row_of(view_.ins(m)[0]), view_.row_of(view_.ins(m)[1])};
  }
  Pair sorted_ins(NodeId m) const { return sorted(row_ins(m)[0], row_ins(m)[1]); }

  /// Next to the in-neighbour it attaches to, on the side of the other one.
  void insert_attached(NodeId m) {
    const NodeId p = attachment_[m];
    const NodeId other = row_ins(m)[row_ins(m)[0] == p ? 1 : 0];
    if (list_.before(p, other)) {
      list_.insert_after(p, m);
    } else {
      list_.insert_before(p, m);
    }
  }

  void insert_chain(const LongVector<NodeId>& chain) {
    for (const NodeId b : chain) {
      if (view_.is_listed_merge(b)) insert_attached(b);
    }
  }

  void place_sink(Pole& pole) {
    if (pole.special == kNone) {
      place_median_sink(pole);
      return;
    }
    const WaitingSink sink = waiting_for(pole);
    const NodeId hold = view_.hold_of(pole);
    const Pair w_ins = sorted_ins(sink.w);
    const NodeId chain_end = sink.chain.empty() ? pole.special : sink.chain.back();
    Pair c_ins;
    if (sink.reaches_c) {  // r2 := the in-neighbour of c that is not on the chain
      const NodeId r2 = row_ins(sink.c)[view_.ins(sink.c)[0] == chain_end ? 1 : 0];
      c_ins = {r2, r2};
    } else {
      c_ins = sorted_ins(sink.c);
    }
    place_hold(pole, sorted(c_ins[0], w_ins[0])[0], sorted(c_ins[1], w_ins[1])[1]);
    if (sink.reaches_c) {
      place_when_chain_reaches(sink, hold, c_ins[1], w_ins, chain_end);
    } else {
      place_apart(sink, hold, c_ins, w_ins);
    }
    expect(list_.before(hold, sink.c) != list_.before(hold, sink.w), "hold lies between c and w");
  }

  /// V-type, list built first: the median of the three is special, the SINK's own row directly
  /// after it.
  void place_median_sink(Pole& pole) {
    const auto three = view_.ins(pole.node);
    std::array<NodeId, 3> m{three[0], three[1], three[2]};
    std::sort(m.begin(), m.end(), [&](NodeId a, NodeId b) { return list_.before(a, b); });
    pole.special = m[1];
    list_.insert_after(m[1], pole.node);
  }

  /// Rule 2.4: hold comes to lie strictly between lo and hi.
  void place_hold(const Pole& pole, NodeId lo, NodeId hi) {
    const NodeId hold = view_.hold_of(pole);
    const bool has_place = list_.contains(hold) || !pole.a_type;
    const NodeId index = pole.special;  // V-type: directly after it
    bool lo_is_nearer = true;
    if (has_place) {
      if (list_.before(lo, index) && list_.before(index, hi)) {
        if (!pole.a_type) list_.insert_after(index, hold);
        return;
      }
      lo_is_nearer = list_.before(index, lo);
    }
    const bool lo_is_outside = !is_in_source_unit(lo, true, hold);
    const bool hi_is_outside = !is_in_source_unit(hi, false, hold);
    expect(has_place || lo_is_outside || hi_is_outside,
           "a SOURCE next to a SINK has a row outside its unit (n >= 8)");
    const bool use_lo = lo_is_outside && hi_is_outside   ? lo_is_nearer
                        : lo_is_outside != hi_is_outside ? lo_is_outside
                                                         : lo_is_nearer;
    if (list_.contains(hold)) list_.remove(hold);
    if (use_lo) {
      list_.insert_after(lo, hold);
    } else {
      list_.insert_before(hi, hold);
    }
  }

  /// True if the index directly after (before) an entry lies between the first two rows of a joint
  /// SOURCE's unit.
  bool is_in_source_unit(NodeId entry, bool after, NodeId hold) const {
    if (!view_.flow().joint) return false;
    for (const Pole& pole : poles_) {
      if (view_.type(pole.node) != NodeType::source) continue;
      const Unit unit = unit_of(view_, pole);
      if (hold == unit.first || hold == unit.second) return false;
      const auto [u1, u2] = sorted(unit.first, unit.second);
      if (after) return !list_.before(entry, u1) && list_.before(entry, u2);
      return list_.before(u1, entry) && !list_.before(u2, entry);
    }
    return false;
  }

  /// Rule 2.4, the chain does not run into c.
  void place_apart(const WaitingSink& sink, NodeId hold, Pair r12, Pair r34) {
    if (list_.before(r34[0], hold) && list_.before(hold, r12[1])) {
      list_.insert_after(r34[0], sink.w);
      list_.insert_before(r12[1], sink.c);
    } else {
      list_.insert_after(r12[0], sink.c);
      list_.insert_before(r34[1], sink.w);
    }
    insert_chain(sink.chain);
  }

  /// Rule 2.4, the chain runs into c.
  void place_when_chain_reaches(const WaitingSink& sink, NodeId hold, NodeId r2, Pair r34,
                                NodeId chain_end) {
    insert_chain(sink.chain);
    if (list_.before(hold, r2)) {
      list_.insert_after(r34[0], sink.w);
    } else {
      list_.insert_before(r34[1], sink.w);
    }
    if (list_.before(chain_end, r2)) {
      list_.insert_before(r2, sink.c);
    } else {
      list_.insert_after(r2, sink.c);
    }
  }

  View view_;
  LongVector<Pole>& poles_;
  Attachment attachment_;
  EntryList list_;
  std::vector<bool> postponed_;
};

}  // namespace

EntryList::EntryList(std::size_t num_nodes, const LongVector<NodeId>& owners) : links_(num_nodes) {
  NodeId last = kNone;
  std::uint32_t rank = 0;
  for (const NodeId v : owners) {
    if (rank + kAhead < owners.size()) prefetch(links_, owners[rank + kAhead]);
    expect(!contains(v), "an owner is listed once");
    links_[v] = {last, kNone, v, rank++};
    (last == kNone ? first_ : links_[last].next) = v;
    last = v;
  }
  for (std::size_t i = 1; i < kWalkers; ++i) {
    const std::size_t index = i * owners.size() / kWalkers;
    if (index > (i - 1) * owners.size() / kWalkers) starts_.push_back(owners[index]);
  }
}

LongVector<NodeId> EntryList::in_order() const {
  LongVector<NodeId> begins{first_};
  for (const NodeId v : starts_) {
    if (v != first_) begins.push_back(v);
  }
  LongVector<LongVector<NodeId>> parts(begins.size());
  LongVector<NodeId> at = begins;
  begins.push_back(kNone);
  for (bool going = first_ != kNone; going;) {
    going = false;
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (at[k] == kNone) continue;
      parts[k].push_back(at[k]);
      at[k] = links_[at[k]].next;
      if (at[k] == begins[k + 1]) at[k] = kNone;
      prefetch(links_, at[k]);
      going = true;
    }
  }
  LongVector<NodeId> result;
  result.reserve(links_.size());
  for (const auto& part : parts) result.insert(result.end(), part.begin(), part.end());
  return result;
}

bool EntryList::before(NodeId u, NodeId v) const {
  const NodeId a = links_[u].cluster;
  const NodeId b = links_[v].cluster;
  expect(a != kNone && b != kNone, "only entries of the list are compared");
  return a != b ? links_[a].rank < links_[b].rank : walk_before(u, v);
}

/// u and v lie in one cluster: looks for v from u in both directions at once.
bool EntryList::walk_before(NodeId u, NodeId v) const {
  if (u == v) return false;
  const NodeId cluster = links_[u].cluster;
  NodeId up = links_[u].next;
  NodeId down = links_[u].previous;
  while (true) {
    if (up == v) return true;
    if (down == v) return false;
    const bool up_ends = up == kNone || links_[up].cluster != cluster;
    const bool down_ends = down == kNone || links_[down].cluster != cluster;
    if (up_ends) return false;
    if (down_ends) return true;
    up = links_[up].next;
    down = links_[down].previous;
  }
}

void EntryList::insert_after(NodeId index, NodeId v) {
  link(index, v, links_[index].next, links_[index].cluster);
}

void EntryList::insert_before(NodeId index, NodeId v) {
  expect(links_[index].previous != kNone, "nothing is put before the first entry");
  link(links_[index].previous, v, index, links_[index].cluster);
}

void EntryList::link(NodeId left, NodeId v, NodeId right, NodeId cluster) {
  expect(cluster != kNone && !contains(v), "a new entry is put next to an entry of the list");
  links_[v] = {left, right, cluster, links_[v].rank};
  links_[left].next = v;
  if (right != kNone) links_[right].previous = v;
}

void EntryList::remove(NodeId v) {
  const ListedEntry link = links_[v];
  const auto shares = [&](NodeId u) { return u != kNone && links_[u].cluster == v; };
  expect(link.cluster == v && !shares(link.previous) && !shares(link.next),
         "a moved owner has nothing attached to it");
  (link.previous == kNone ? first_ : links_[link.previous].next) = link.next;
  if (link.next != kNone) links_[link.next].previous = link.previous;
  links_[v].cluster = kNone;
  std::erase(starts_, v);
}

LongVector<NodeId> build_view_list(Flow& flow, bool columns,
                                   const LongVector<std::uint32_t>& weights) {
  return ListBuilder(flow, columns, weights).build();
}

void choose_outer_specials(Flow& flow, bool columns_are_second,
                           const LongVector<NodeId>& first_list) {
  const View second(flow, columns_are_second);
  LongVector<Pole>& poles = flow.poles;
  const bool any = std::any_of(poles.begin(), poles.end(), [&](const Pole& pole) {
    return second.type(pole.node) == NodeType::sink && pole.special == kNone;
  });
  if (!any) return;
  const Values index = list_indices(View(flow, !columns_are_second), first_list);
  for (Pole& pole : poles) {
    if (second.type(pole.node) != NodeType::sink || pole.special != kNone) continue;
    const auto three = second.ins(pole.node);
    std::array<NodeId, 3> m{three[0], three[1], three[2]};
    std::sort(m.begin(), m.end(), [&](NodeId a, NodeId b) { return index[a] < index[b]; });
    pole.special = index[m[2]] - index[m[1]] > index[m[1]] - index[m[0]] ? m[2] : m[0];
  }
}

}  // namespace ar3d::two_bend
