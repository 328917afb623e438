// Steps 2.7 to 2.10: rounds that number, choose and fit, and widen only what failed; most drawings
// succeed at once and stay small, which reserving room beforehand would prevent. That a round
// succeeds is not proved, so behind the rounds stands the layout that cannot fail: it reserves the
// room that the lemmas ask for, and no more, so that the box of the drawing can be proved. Cost:
// O(n) for each numbering, of which there are at most ten, and a few for the safe layout.
#include "ar3d/algorithms/two_bend/layout.h"

#include <bit>
#include <cstdlib>

namespace ar3d::two_bend {

std::array<std::int64_t, 2> vv_room(std::size_t num_nodes) {
  if (num_nodes <= 400) return {4, 2};
  return {7, 3};
}

std::int64_t far_b(std::int64_t k, bool alone) {
  if (alone) return 1;
  return k - static_cast<std::int64_t>(std::bit_floor(static_cast<std::uint64_t>(k - 1)));
}

std::int64_t far_gap(std::int64_t k, bool alone) {
  const std::int64_t b = far_b(k, alone);
  return 2 * b + (7 * (k - b) + 15) / 16 + 1;
}

namespace {

/// Holds what every layout is made of: both views, what widens their lists, and the numbers so far.
class NumberedLists {
 protected:
  NumberedLists(const Flow& flow, const Lists& lists)
      : flow_(flow), lists_(lists), views_{View(flow, false), View(flow, true)} {}

  const View& view_of(const Pole& pole) const {  // the view in which the pole is a SINK
    return views_[flow_.nodes[pole.node].type == NodeType::sink ? 0 : 1];
  }
  Spacing& spacing_of(const View& view) { return spacings_[view.columns() ? 1 : 0]; }
  Widening& hold_spacing(const Pole& pole) {
    const View& view = view_of(pole);
    return spacing_of(view)[view.hold_of(pole)];
  }
  ViewValues values_of(const View& view) const {
    return view.columns() ? ViewValues{layout_.columns, layout_.rows}
                          : ViewValues{layout_.rows, layout_.columns};
  }

  void number() {
    auto& [row_bound, column_bound] = layout_.width_bound;
    layout_.rows = number_list(views_[0], lists_[0], spacings_[0], row_bound);
    layout_.columns = number_list(views_[1], lists_[1], spacings_[1], column_bound);
  }
  void choose_middles(bool relaxes) {
    choose_middle_values(views_[0], relaxes, layout_.rows);
    choose_middle_values(views_[1], relaxes, layout_.columns);
  }
  /// False if the VV edge finds no primitive lean.
  bool choose_lean(LongId e) {
    return choose_vv_values(flow_, flow_.edges[e], layout_.rows, layout_.columns);
  }

  const Flow& flow_;
  const Lists& lists_;
  const std::array<View, 2> views_;  // rows, columns
  std::array<Spacing, 2> spacings_;
  Layout layout_;
};

constexpr std::int64_t kFirstGap = 8;
constexpr unsigned kVvFailures = 5;  // then every VV interval is widened
// So many odd numbers in an interval make a primitive VV lean certain.
constexpr std::int64_t kVvCount = 8;

class LayoutSearch : private NumberedLists {
 public:
  LayoutSearch(const Flow& flow, const Lists& lists, bool relaxes)
      : NumberedLists(flow, lists), relaxes_(relaxes), vv_(flow.vv_edges) {
    for (const Pole& pole : flow.poles) gap_of(pole) = kFirstGap;
  }

  std::optional<Layout> run() {
    for (unsigned round = 1; round <= kOrdinaryRounds; ++round) {
      layout_.rounds = round;
      number();
      if (!choose_free_values() || !fit_poles()) continue;
      for (const Pole& pole : flow_.poles) {
        layout_.largest_gap = std::max(layout_.largest_gap, gap_of(pole));
      }
      return std::move(layout_);
    }
    return std::nullopt;
  }

 private:
  std::int64_t& gap_of(const Pole& pole) { return hold_spacing(pole).hold_gap; }

  /// False if a VV edge found no primitive lean; then the intervals are wider for the next round.
  bool choose_free_values() {
    choose_middles(relaxes_);
    LongVector<LongId> failed;
    for (std::size_t i = 0; i < vv_.size(); ++i) {
      prefetch_vv_edge(i + kAhead);
      if (!choose_lean(vv_[i])) failed.push_back(vv_[i]);
    }
    if (failed.empty()) return true;
    widen_vv(++vv_failures_ < kVvFailures ? failed : vv_);
    return false;
  }

  /// Prefetches what the values of a VV edge soon to be chosen depend on.
  [[gnu::always_inline]] void prefetch_vv_edge(std::size_t i) const {
    if (i >= vv_.size()) return;
    const LongEdge& edge = flow_.edges[vv_[i]];
    prefetch(layout_.columns, edge.lower);
    prefetch(layout_.rows, edge.upper);
    for (const NodeId u : views_[0].ins(edge.lower)) prefetch(layout_.rows, u);
    for (const NodeId u : views_[1].ins(edge.upper)) prefetch(layout_.columns, u);
  }

  void widen(const View& view, NodeId merge, std::int64_t by) {
    const Values& values = values_of(view).own;
    const auto below = view.ins(merge);
    const NodeId lower = values[below[1]] < values[below[0]] ? below[1] : below[0];
    spacing_of(view)[view.row_of(lower)].extra_after += by;
  }

  /// The intervals of these VV edges get room for kVvCount odd numbers.
  void widen_vv(const LongVector<LongId>& edges) {
    const auto widen_to_count = [&](const View& view, NodeId merge) {
      const std::int64_t missing = kVvCount - interval_of(view, values_of(view).own, merge).count();
      if (missing > 0) widen(view, merge, 2 * missing);
    };
    for (const LongId e : edges) {
      widen_to_count(views_[0], flow_.edges[e].lower);
      widen_to_count(views_[1], flow_.edges[e].upper);
    }
  }

  /// False if a pole found no leans; the gaps of all that failed are then wider for the next round.
  bool fit_poles() {
    layout_.poles.clear();
    bool all_fit = true;
    for (const Pole& pole : flow_.poles) {
      const View& view = view_of(pole);
      std::int64_t& gap = gap_of(pole);
      if (const auto shape = fit_pole(view, values_of(view), pole, gap)) {
        layout_.poles.push_back(*shape);
      } else {
        gap += gap / 4 + 1;
        all_fit = false;
      }
    }
    return all_fit;
  }

  const bool relaxes_;
  const LongVector<LongId>& vv_;
  unsigned vv_failures_ = 0;
};

constexpr std::int64_t kNearGap = 8;       // the near lean fits by Lemma 2.13
constexpr std::uint32_t kSinkWeight = 30;  // half of what a SINK's gaps take of its block's rows

/// The end of a VV edge that is a MERGE of the view.
NodeId free_merge_of(const View& view, const LongEdge& edge) {
  return view.columns() ? edge.upper : edge.lower;
}

/// Half the length that each node takes of the list.
LongVector<std::uint32_t> lengths_of(const View& view) {
  const Flow& flow = view.flow();
  const std::int64_t room = vv_room(flow.nodes.size())[view.columns() ? 1 : 0];
  LongVector<std::uint32_t> weights(view.size(), 1);
  for (NodeId v = 0; v < view.size(); ++v) {
    if (view.type(v) == NodeType::station) weights[v] = 2;
    if (view.type(v) == NodeType::sink && !flow.joint) weights[view.ins(v)[0]] += kSinkWeight;
  }
  for (const LongId e : flow.vv_edges) {
    weights[view.ins(free_merge_of(view, flow.edges[e]))[0]] +=
        static_cast<std::uint32_t>(room - 1);
  }
  return weights;
}

class SafeLayout : private NumberedLists {
 public:
  SafeLayout(const Flow& flow, const Lists& lists)
      : NumberedLists(flow, lists), gaps_(flow.poles.size(), kNearGap) {}

  Layout run() {
    layout_.safe = true;
    number();
    const auto [row_room, column_room] = vv_room(flow_.nodes.size());
    for (const LongId e : flow_.vv_edges) {
      widen(views_[0], flow_.edges[e].lower, row_room);
      widen(views_[1], flow_.edges[e].upper, column_room);
    }
    for (const Pole& pole : flow_.poles) hold_spacing(pole).hold_gap = kNearGap;
    number();
    for (; widen_poles(); ++layout_.rounds) number();
    choose_middles(false);
    for (const LongId e : flow_.vv_edges) {
      expect(choose_lean(e), "the reserved room always holds a primitive VV lean");
    }
    fit_poles();
    for (const std::int64_t gap : gaps_) layout_.largest_gap = std::max(layout_.largest_gap, gap);
    return std::move(layout_);
  }

 private:
  /// The pole is the first or the last vertex of its component: no other ray passes its slab.
  bool is_alone(const Pole& pole) const {
    return flow_.joint || flow_.nodes[pole.node].type == NodeType::source;
  }

  /// Room for `count` odd numbers beside an in-neighbour of the MERGE, towards the other one.
  void widen(const View& view, NodeId merge, std::int64_t count) {
    const Values& own = values_of(view).own;
    const auto below = view.ins(merge);
    Widening& widening = spacing_of(view)[below[0]];
    (own[below[0]] < own[below[1]] ? widening.extra_after : widening.extra_before) +=
        2 * (count - 1);
  }

  std::int64_t spread(const Pole& pole) const {
    const View& view = view_of(pole);
    const auto [c, w] = view.ordinary_of(pole);
    const Values& cross = values_of(view).cross;
    return std::abs(cross[c] - cross[w]);
  }

  /// The ordinary neighbour that is farther from the special edge.
  NodeId far_neighbour(const Pole& pole) const {
    const View& view = view_of(pole);
    const auto [c, w] = view.ordinary_of(pole);
    const Values& cross = values_of(view).cross;
    const NodeId beside = pole.a_type ? pole.node : pole.special;
    return std::abs(cross[c] - cross[beside]) > std::abs(cross[w] - cross[beside]) ? c : w;
  }

  /// True if a gap was too narrow for the distances across; then it is wide enough for them. The
  /// distances grow with the gaps of the other pole of a joint component, but less: Lemma 2.15.
  bool widen_poles() {
    bool changed = false;
    for (std::size_t i = 0; i < flow_.poles.size(); ++i) {
      const Pole& pole = flow_.poles[i];
      const std::int64_t missing = far_gap(spread(pole), is_alone(pole)) - gaps_[i];
      if (missing <= 0) continue;
      const View& view = view_of(pole);
      const Values& own = values_of(view).own;
      Widening& widening = hold_spacing(pole);
      const bool above = own[far_neighbour(pole)] > own[view.hold_of(pole)];
      const std::int64_t by = missing + missing % 2;
      (above ? widening.extra_after : widening.extra_before) += by;
      gaps_[i] += by;
      changed = true;
    }
    return changed;
  }

  void fit_poles() {
    for (const Pole& pole : flow_.poles) {
      const View& view = view_of(pole);
      const bool alone = is_alone(pole);
      layout_.poles.push_back(
          safe_pole(view, values_of(view), pole, far_b(spread(pole), alone), alone));
    }
  }

  LongVector<std::int64_t> gaps_;  // per pole, on the far side of its special row
};

}  // namespace

std::optional<Layout> find_layout(const Flow& flow, const Lists& lists, bool relaxes) {
  return LayoutSearch(flow, lists, relaxes).run();
}

Lists build_safe_lists(Flow& flow) {
  return build_lists(flow, /*share=*/false,
                     {lengths_of(View(flow, false)), lengths_of(View(flow, true))});
}

Layout find_safe_layout(const Flow& flow, const Lists& lists) {
  return SafeLayout(flow, lists).run();
}

}  // namespace ar3d::two_bend
