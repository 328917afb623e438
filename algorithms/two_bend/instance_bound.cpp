// The bound that the proof of Lemma 2.18 gives for one drawing, from its own numbers of parts
// instead of worst cases. It is computed from flow and layout, never from the points it is compared
// with. Cost: O(n).
#include "ar3d/algorithms/two_bend/instance_bound.h"

#include <algorithm>
#include <cstdlib>

#include "ar3d/algorithms/two_bend/fixed_bodies.h"

namespace ar3d::two_bend {
namespace {

/// What a lean over q rows adds to the length of its arm and its run at most: that of run 1.
std::int64_t lean_excess(std::int64_t q) { return std::max(q + 1, (q * q + 1) / 2); }

/// Excess of the leans into the MERGEs of a view, and of the special edges of its V-type SINKs.
std::int64_t lean_excesses(const View& view, const Values& cross, const Values& own) {
  std::int64_t sum = 0;
  for (NodeId i = 0; i < view.size(); ++i) {
    const NodeId m = view.at(i);
    view.ask(i + kAhead, cross);
    if (view.type(m) == NodeType::sink && !view.pole(m).a_type) {
      const Pole& pole = view.pole(m);
      sum += lean_excess(std::abs(own[pole.special] - own[pole.node]));
    }
    if (view.type(m) != NodeType::merge) continue;
    for (const NodeId u : view.ins(m)) {
      const NodeType below = view.type(u);
      if (below == NodeType::merge || below == NodeType::station)
        sum += lean_excess(std::abs(cross[u] - cross[m]));
    }
  }
  return sum;
}

}  // namespace

void InstanceBound::add(const std::array<std::int64_t, 3>& component) {
  extents[0] = std::max(extents[0], component[0]);
  extents[1] = std::max(extents[1], component[1]);
  extents[2] += component[2];
}

std::array<std::int64_t, 3> bound_component(const Flow& flow, const Layout& layout,
                                            std::size_t places, std::size_t bodies) {
  const std::int64_t margin = 2 * (layout.largest_gap + kQHalfWidth) + 1;
  const std::int64_t x = layout.width_bound[1] + margin;
  const std::int64_t y = layout.width_bound[0] + margin;
  std::int64_t z = static_cast<std::int64_t>(places) +
                   static_cast<std::int64_t>(bodies) * kQHeight +
                   lean_excesses(View(flow, false), layout.columns, layout.rows) +
                   lean_excesses(View(flow, true), layout.rows, layout.columns);
  for (const Node& node : flow.nodes) {
    if (node.type == NodeType::split) z += x;
    if (node.type == NodeType::merge) z += y;
    if (node.type == NodeType::source || node.type == NodeType::sink) z += x + y + margin;
  }
  z += static_cast<std::int64_t>(flow.vv_edges.size()) * (x + y + 2);
  return {x, y, z};
}

}  // namespace ar3d::two_bend
