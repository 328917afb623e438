// Steps 2.7 to 2.9: both lists, then rounds that number, choose and fit, and widen only what
// failed. Most drawings succeed at once and stay small, which reserving room beforehand would
// prevent. That a round succeeds is not proved; safe_layout.cpp stands behind them. Cost: O(n) per
// round, at most ten.
#include "ar3d/algorithms/two_bend/layout.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "ar3d/algorithms/two_bend/shared_rows.h"
#include "ar3d/algorithms/two_bend/view_list.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend {

Lists build_lists(Flow& flow, const ListOptions& options) {
  const bool columns_first =
      flow.joint && std::any_of(flow.poles.begin(), flow.poles.end(), [&](const Pole& p) {
        return flow.nodes[p.node].type == NodeType::source && p.a_type;
      });
  if (options.share)
    share_rows(flow, columns_first, guess_rows(flow, !columns_first, options.straighten));
  LongVector<NodeId> first = build_view_list(flow, columns_first, options.straighten,
                                             options.weights[columns_first ? 1 : 0]);
  choose_outer_specials(flow, !columns_first, first);
  if (options.share)
    share_rows(flow, !columns_first, list_places(View(flow, columns_first), first));
  LongVector<NodeId> second = build_view_list(flow, !columns_first, options.straighten,
                                              options.weights[columns_first ? 0 : 1]);
  if (options.share) {
    separate_rows(flow, columns_first, list_places(View(flow, !columns_first), second), first);
  }
  if (columns_first) std::swap(first, second);
  expect_heavy(
      [&] {
        const View rows(flow, false);
        const View columns(flow, true);
        return shared_rows_are_plane(rows, list_places(columns, second)) &&
               shared_rows_are_plane(columns, list_places(rows, first));
      },
      "arms in a shared row or column do not meet");
  return {std::move(first), std::move(second)};
}

namespace {

constexpr std::int64_t kFirstGap = 8;
constexpr unsigned kVvFailures = 5;  // then every VV interval is widened
constexpr std::int64_t kVvCount =
    8;  // odd numbers in an interval that make a primitive VV lean certain

class LayoutSearch {
 public:
  LayoutSearch(const Flow& flow, const Lists& lists, unsigned relax_passes)
      : flow_(flow),
        lists_(lists),
        relax_passes_(relax_passes),
        row_view_(flow, false),
        column_view_(flow, true),
        vv_(flow.vv_edges),
        row_spacing_(flow.nodes.size()),
        column_spacing_(flow.nodes.size()) {
    for (const Pole& pole : flow.poles) set_gap(pole, kFirstGap);
  }

  std::optional<Layout> run() {
    for (unsigned round = 1; round <= kOrdinaryRounds; ++round) {
      layout_.rounds = round;
      number();
      if (choose_free_values() && fit_poles()) return finish();
    }
    return std::nullopt;
  }

 private:
  Layout finish() {
    layout_.width_bound = {bound_of_list(row_view_, row_spacing_),
                           bound_of_list(column_view_, column_spacing_)};
    for (const Pole& pole : flow_.poles)
      layout_.largest_gap = std::max(layout_.largest_gap, gap_of(pole));
    return std::move(layout_);
  }

  const View& view_of(const Pole& pole) const {  // the view in which the pole is a SINK
    return flow_.nodes[pole.node].type == NodeType::sink ? row_view_ : column_view_;
  }
  Spacing& spacing_of(const View& view) { return view.columns() ? column_spacing_ : row_spacing_; }
  ViewValues values_of(const View& view) const {
    return view.columns() ? ViewValues{layout_.columns, layout_.rows}
                          : ViewValues{layout_.rows, layout_.columns};
  }
  std::int64_t& gap_of(const Pole& pole) {
    const View& view = view_of(pole);
    return spacing_of(view).at(view.hold_of(pole)).hold_gap;
  }
  void set_gap(const Pole& pole, std::int64_t gap) { gap_of(pole) = gap; }

  void number() {
    layout_.rows = number_list(row_view_, lists_.rows, row_spacing_);
    layout_.columns = number_list(column_view_, lists_.columns, column_spacing_);
    relax_merges(row_view_, relax_passes_, layout_.rows);
    relax_merges(column_view_, relax_passes_, layout_.columns);
  }

  /// False if a VV edge found no primitive lean; then the intervals are wider for the next round.
  bool choose_free_values() {
    choose_middle_values(row_view_, layout_.rows);
    choose_middle_values(column_view_, layout_.columns);
    LongVector<LongId> failed;
    for (std::size_t i = 0; i < vv_.size(); ++i) {
      const LongId e = vv_[i];
      ask_for_vv_edge(i + kAhead);
      if (!choose_vv_values(flow_, flow_.edges[e], layout_.rows, layout_.columns))
        failed.push_back(e);
    }
    if (failed.empty()) return true;
    widen_vv(++vv_failures_ < kVvFailures ? failed : vv_);
    return false;
  }

  /// Asks memory for what the values of a VV edge soon to be chosen depend on.
  [[gnu::always_inline]] void ask_for_vv_edge(std::size_t i) const {
    if (i >= vv_.size()) return;
    const LongEdge& edge = flow_.edges[vv_[i]];
    ask_for(layout_.columns, edge.lower);
    ask_for(layout_.rows, edge.upper);
    for (const NodeId u : row_view_.ins(edge.lower)) ask_for(layout_.rows, u);
    for (const NodeId u : column_view_.ins(edge.upper)) ask_for(layout_.columns, u);
  }

  void widen(const View& view, NodeId merge, std::int64_t by) {
    const Values& values = values_of(view).own;
    const auto below = view.ins(merge);
    const NodeId lower = values[below[1]] < values[below[0]] ? below[1] : below[0];
    spacing_of(view).at(view.row_of(lower)).extra_after += by;
  }

  /// The intervals of these VV edges get room for kVvCount odd numbers.
  void widen_vv(const LongVector<LongId>& edges) {
    const auto widen_to_count = [&](const View& view, NodeId merge) {
      const std::int64_t missing = kVvCount - interval_of(view, values_of(view).own, merge).count();
      if (missing > 0) widen(view, merge, 2 * missing);
    };
    for (const LongId e : edges) {
      widen_to_count(row_view_, flow_.edges[e].lower);
      widen_to_count(column_view_, flow_.edges[e].upper);
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

  const Flow& flow_;
  const Lists& lists_;
  const unsigned relax_passes_;
  const View row_view_;
  const View column_view_;
  const LongVector<LongId>& vv_;
  Spacing row_spacing_;
  Spacing column_spacing_;
  unsigned vv_failures_ = 0;
  Layout layout_;
};

}  // namespace

std::optional<Layout> find_layout(const Flow& flow, const Lists& lists, unsigned relax_passes) {
  return LayoutSearch(flow, lists, relax_passes).run();
}

}  // namespace ar3d::two_bend
