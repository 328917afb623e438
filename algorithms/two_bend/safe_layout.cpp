// Step 2.10 of docs/theorem2.md: the layout that cannot fail. The ordinary rounds search, and
// nobody has shown that they always find; this one reserves beforehand the room that the lemmas ask
// for, and no more, so that the box of the drawing can be proved. A pole that has its slab for
// itself (every SOURCE, and the SINK of a cubic bridgeless component) needs far less room than one
// among other rays. Cost: O(n) for each of the few times that all is numbered.
#include "ar3d/algorithms/two_bend/safe_layout.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <utility>

#include "ar3d/base/error.h"

namespace ar3d::two_bend {

VvRoom vv_room(std::size_t num_nodes) { return num_nodes <= 400 ? VvRoom{4, 2} : VvRoom{7, 3}; }

std::int64_t far_b(std::int64_t k, bool alone) {
  if (alone) return 1;
  return k - static_cast<std::int64_t>(std::bit_floor(static_cast<std::uint64_t>(k - 1)));
}

std::int64_t far_gap(std::int64_t k, bool alone) {
  const std::int64_t b = far_b(k, alone);
  return 2 * b + (7 * (k - b) + 15) / 16 + 1;
}

namespace {

constexpr std::int64_t kNearGap = 8;       // the near lean fits by Lemma 2.13
constexpr std::uint32_t kSinkWeight = 30;  // half of what a SINK's gaps take of its block's rows

/// The end of a VV edge that is a MERGE of the view.
NodeId free_merge_of(const View& view, const LongEdge& edge) {
  return view.columns() ? edge.upper : edge.lower;
}

/// Half the length that each node takes of the list.
LongVector<std::uint32_t> lengths_of(const View& view) {
  const Flow& flow = view.flow();
  const VvRoom room = vv_room(flow.nodes.size());
  LongVector<std::uint32_t> weights(view.size(), 1);
  for (NodeId v = 0; v < view.size(); ++v) {
    if (view.type(v) == NodeType::station) weights[v] = 2;
    if (view.type(v) == NodeType::sink && !flow.joint) weights[view.ins(v)[0]] += kSinkWeight;
  }
  for (const LongId e : flow.vv_edges) {
    weights[view.ins(free_merge_of(view, flow.edges[e]))[0]] +=
        static_cast<std::uint32_t>((view.columns() ? room.columns : room.rows) - 1);
  }
  return weights;
}

class SafeLayout {
 public:
  SafeLayout(const Flow& flow, const Lists& lists)
      : flow_(flow),
        lists_(lists),
        views_{View(flow, false), View(flow, true)},
        spacings_{Spacing(flow.nodes.size()), Spacing(flow.nodes.size())},
        gaps_(flow.poles.size(), kNearGap) {}

  Layout run() {
    number();
    const LongVector<LongId>& vv = flow_.vv_edges;
    const VvRoom room = vv_room(flow_.nodes.size());
    for (const LongId e : vv) {
      widen(views_[0], flow_.edges[e].lower, room.rows);
      widen(views_[1], flow_.edges[e].upper, room.columns);
    }
    for (const Pole& pole : flow_.poles) hold_spacing(pole).hold_gap = kNearGap;
    do {
      number();
      ++layout_.rounds;
    } while (widen_poles());
    choose_middle_values(views_[0], layout_.rows);
    choose_middle_values(views_[1], layout_.columns);
    for (const LongId e : vv) {
      expect(choose_vv_values(flow_, flow_.edges[e], layout_.rows, layout_.columns),
             "the reserved room always holds a primitive VV lean");
    }
    fit_poles();
    return finish();
  }

 private:
  const View& view_of(const Pole& pole) const {  // the view in which the pole is a SINK
    return views_[flow_.nodes[pole.node].type == NodeType::sink ? 0 : 1];
  }
  ViewValues values_of(const View& view) const {
    return view.columns() ? ViewValues{layout_.columns, layout_.rows}
                          : ViewValues{layout_.rows, layout_.columns};
  }
  Spacing& spacing_of(const View& view) { return spacings_[view.columns() ? 1 : 0]; }
  Spacing::Widening& hold_spacing(const Pole& pole) {
    const View& view = view_of(pole);
    return spacing_of(view).at(view.hold_of(pole));
  }
  /// The pole is the first or the last vertex of its component: no other ray passes its slab.
  bool is_alone(const Pole& pole) const {
    return flow_.joint || flow_.nodes[pole.node].type == NodeType::source;
  }

  void number() {
    layout_.rows = number_list(views_[0], lists_.rows, spacings_[0]);
    layout_.columns = number_list(views_[1], lists_.columns, spacings_[1]);
  }

  /// Room for `count` odd numbers beside an in-neighbour of the MERGE, towards the other one.
  void widen(const View& view, NodeId merge, std::int64_t count) {
    const Values& own = values_of(view).own;
    const auto below = view.ins(merge);
    Spacing::Widening& widening = spacing_of(view).at(below[0]);
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
      Spacing::Widening& widening = hold_spacing(pole);
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

  Layout finish() {
    layout_.safe = true;
    --layout_.rounds;  // counted from 1
    for (std::size_t i : {0u, 1u}) layout_.width_bound[i] = bound_of_list(views_[i], spacings_[i]);
    for (const std::int64_t gap : gaps_) layout_.largest_gap = std::max(layout_.largest_gap, gap);
    return std::move(layout_);
  }

  const Flow& flow_;
  const Lists& lists_;
  const std::array<View, 2> views_;  // rows, columns
  std::array<Spacing, 2> spacings_;
  LongVector<std::int64_t> gaps_;  // per pole, on the far side of its special row
  Layout layout_;
};

}  // namespace

Lists build_safe_lists(Flow& flow) {
  ListOptions options{.share = false, .straighten = false, .weights = {}};
  options.weights[0] = lengths_of(View(flow, false));
  options.weights[1] = lengths_of(View(flow, true));
  return build_lists(flow, options);
}

Layout find_safe_layout(const Flow& flow, const Lists& lists) {
  return SafeLayout(flow, lists).run();
}

}  // namespace ar3d::two_bend
