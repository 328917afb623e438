// Rules 2.5 to 2.7: numbers along a list, MERGEs moved towards the middle, free rows and columns.
// Parity keeps rays apart without any look-up: owners are even, MERGEs odd. The pair of a VV edge
// is searched outwards from the middles, since the angle there is best; Lemma 2.9 says when a pair
// must exist. Cost: O(n) and a greatest common divisor per try.
#include "ar3d/algorithms/two_bend/coordinates.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

/// Least distance of a MERGE's row from the row of an in-neighbour.
std::int64_t margin(NodeType below) {
  return below == NodeType::station ? 3 : below == NodeType::merge ? 2 : 1;
}

bool is_odd(NodeType type) { return type == NodeType::merge; }

std::int64_t base_gap(NodeType a, NodeType b) {
  if (is_odd(a) == is_odd(b)) return 2;
  return a == NodeType::station || b == NodeType::station ? 3 : 1;
}

std::int64_t bound_of_entry(NodeType type, const Widening& widening) {
  const auto [extra_before, extra_after, hold_gap] = widening;
  std::int64_t bound = type == NodeType::station ? 4 : 2;
  if (extra_before + extra_after > 0) bound += extra_before + extra_after + 1;
  if (hold_gap > 0) bound += 2 * (hold_gap + 1);
  return bound;
}

/// SPLITs stand where their row's owner stands.
void copy_to_sharers(const View& view, Values& values) {
  for (NodeId v = 0; v < view.size(); ++v) {
    if (view.row_of(v) != v) values[v] = values[view.row_of(v)];
  }
}

void relax_merge(const View& view, Values& values, NodeId m) {
  if (!view.is_listed_merge(m) || view.is_free_merge(m)) return;
  const NodeId above = view.outs(m)[0];
  if (view.type(above) != NodeType::merge) return;
  const View cross(view.flow(), !view.columns());
  if (cross.shares_row(above) && cross.row_of(m) != cross.row_of(above)) return;
  OddInterval room = interval_of(view, values, m);
  const std::int64_t middle = room.middle();
  const std::int64_t nearest =
      view.is_free_merge(above) ? std::abs(values[m] - values[above]) : margin(NodeType::merge);
  if (values[m] < values[above]) {
    room.high = std::min(room.high, values[above] - nearest);
  } else {
    room.low = std::max(room.low, values[above] + nearest);
  }
  expect(room.contains(values[m]), "a listed MERGE keeps its distances");
  values[m] = static_cast<std::int32_t>(std::clamp(middle, room.low, room.high));
}

}  // namespace

Values list_indices(const View& view, const LongVector<NodeId>& list) {
  Values indices(view.size(), 0);
  std::int32_t count = 0;
  for (const NodeId v : list) indices[v] = count++;
  copy_to_sharers(view, indices);
  return indices;
}

Values number_list(const View& view, const LongVector<NodeId>& list, const Spacing& spacing,
                   std::int64_t& bound) {
  Values values(view.size(), 0);
  bound = 0;
  std::int64_t value = -2;  // the first entry gets 0 or 1
  NodeType last = NodeType::split;
  Widening before;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const NodeId v = list[i];
    if (i + kAhead < list.size()) {
      view.prefetch_type_of(list[i + kAhead]);
      prefetch(values, list[i + kAhead]);
    }
    const NodeType type = view.type(v);
    const auto found = spacing.find(v);
    const Widening widening = found == spacing.end() ? Widening{} : found->second;
    const bool is_first = value < 0;
    value += is_first ? 2
                      : std::max({base_gap(last, type), before.hold_gap, widening.hold_gap}) +
                            before.extra_after + widening.extra_before;
    if ((value % 2 != 0) != is_odd(type)) ++value;
    expect(value <= kMaxHorizontal, "rows and columns fit 31 bits");
    values[v] = static_cast<std::int32_t>(value);
    bound += bound_of_entry(type, widening);
    last = type;
    before = widening;
  }
  copy_to_sharers(view, values);
  return values;
}

OddInterval interval_of(const View& view, const Values& values, NodeId merge) {
  NodeId a = view.ins(merge)[0];
  NodeId b = view.ins(merge)[1];
  if (values[b] < values[a]) std::swap(a, b);
  const OddInterval result{values[a] + margin(view.type(a)), values[b] - margin(view.type(b))};
  expect(result.low <= result.high && result.low % 2 == 1,
         "a free MERGE has room between its in-neighbours");
  return result;
}

void choose_middle_values(const View& view, bool relaxes, Values& values) {
  for (NodeId i = view.size(); relaxes && i-- > 0;) {
    view.prefetch_neighbours(i - kAhead, values);
    view.prefetch_types(i - kAhead);
    relax_merge(view, values, view.at(i));
  }
  for (NodeId i = 0; i < view.size(); ++i) {  // what lies below a free MERGE has its index
    const NodeId m = view.at(i);
    view.prefetch_neighbours(i + kAhead, values);
    view.prefetch_types(i + kAhead);
    if (view.is_free_merge(m)) {
      const auto above = view.outs(m);
      if (!above.empty() && view.type(above[0]) == NodeType::split) continue;
      values[m] = static_cast<std::int32_t>(interval_of(view, values, m).middle());
    } else if (relaxes) {
      relax_merge(view, values, m);
    }
  }
}

bool choose_vv_values(const Flow& flow, const LongEdge& edge, Values& rows, Values& columns) {
  const OddInterval row = interval_of(View(flow, false), rows, edge.lower);
  const OddInterval column = interval_of(View(flow, true), columns, edge.upper);
  const std::int64_t x = columns[edge.lower];
  const std::int64_t y = rows[edge.upper];
  if (row.contains(y) && column.contains(x)) {  // one above the other
    rows[edge.lower] = rows[edge.upper];
    columns[edge.upper] = columns[edge.lower];
    return true;
  }
  const auto try_pair = [&](std::int64_t r, std::int64_t c) {
    if (!row.contains(r) || !column.contains(c) || std::gcd(c - x, y - r) != 1) return false;
    rows[edge.lower] = static_cast<std::int32_t>(r);
    columns[edge.upper] = static_cast<std::int32_t>(c);
    return true;
  };
  for (std::int64_t ring = 0; ring < 8; ++ring) {
    for (std::int64_t i = -ring; i <= ring; ++i) {
      const std::int64_t step = std::abs(i) == ring ? 1 : 2 * ring;  // whole sides, else both ends
      for (std::int64_t j = -ring; j <= ring; j += step) {
        if (try_pair(row.middle() + 2 * i, column.middle() + 2 * j)) return true;
      }
    }
  }
  return false;
}

}  // namespace ar3d::two_bend
