// Step 2.11, one vertex at a time: the bends around it, and how much of the height it takes.
// Written for MERGEs and SINKs of a view; SPLITs and SOURCEs are the same in the reversed view.
// Cost: O(n).
#include "ar3d/algorithms/two_bend/slab.h"

#include <cstdlib>

namespace ar3d::two_bend {

Point ray_of(const Flow& flow, const Layout& layout, const LongEdge& edge) {
  const NodeType lower = flow.types[0][edge.lower];
  const NodeType upper = flow.types[0][edge.upper];
  const auto at = [&](NodeId column, NodeId row) {
    return Point{layout.columns[column], layout.rows[row], 0};
  };
  if (lower == NodeType::merge || lower == NodeType::station) return at(edge.lower, edge.lower);
  if (upper == NodeType::split || upper == NodeType::station) return at(edge.upper, edge.upper);
  return at(edge.upper, edge.lower);
}

namespace {

int sign_of(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Draws, for one view, the ends of long edges below its MERGEs and SINKs (and around: a SINK has
/// bends above itself).
class ViewSlabs {
 public:
  ViewSlabs(const View& view, const Layout& layout, Slabs& slabs)
      : view_(view),
        poles_(layout.poles),
        own_(view.columns() ? layout.columns : layout.rows),
        cross_(view.columns() ? layout.rows : layout.columns),
        slabs_(slabs) {}

  /// The end at v of an edge that comes from u, in the view's time.
  void draw_end(LongBends& edge, NodeId v, NodeId u) {
    if (view_.type(v) == NodeType::merge) draw_at_merge(v, edge, u);
    if (view_.type(v) == NodeType::sink) draw_at_sink(view_.pole(v), edge, u);
  }

 private:
  void draw_at_merge(NodeId m, LongBends& edge, NodeId u) {
    const NodeType below = view_.type(u);
    const bool in_one_column = cross_[u] == cross_[m];  // see share_rows
    const bool ends_vertically = below == NodeType::merge || below == NodeType::station;
    if (ends_vertically) count_excess(cross_[u] - cross_[m]);
    if (!in_one_column && ends_vertically) {
      add_lean_and_arm(m, edge, u);
    } else {
      add(m, edge, cross_[m], own_[u], std::abs(own_[m] - own_[u]));
    }
  }

  /// Of a lean over q rows: what it adds to the length of its arm and its run at most (run 1).
  void count_excess(std::int64_t q) {
    slabs_.lean_excess += std::max(std::abs(q) + 1, (q * q + 1) / 2);
  }

  void draw_at_sink(const Pole& pole, LongBends& edge, NodeId u) {
    const PoleShape& shape = poles_[view_.flow().pole_of(pole.node)];
    if (u == shape.up.from) {
      add_pole_lean(pole.node, edge, shape, shape.up, 1);
    } else if (u == shape.down.from) {
      add_pole_lean(pole.node, edge, shape, shape.down, -1);
    } else {
      add_special(pole, edge, shape);
    }
  }

  /// A bend in the view's coordinates, `drop` below v in its time; in upward order of the view. The
  /// slab of the vertex grows with it.
  void add(NodeId v, LongBends& edge, std::int64_t cross, std::int64_t own, std::int64_t drop) {
    SlabHeights& slab = slabs_.of_node[v];
    if (view_.columns()) {
      edge.add_lower(bend_at(own, cross, drop));
      slab.above = std::max(slab.above, drop);
      slab.below = std::max(slab.below, -drop);
    } else {
      edge.add_upper(bend_at(cross, own, -drop));
      slab.below = std::max(slab.below, drop);
      slab.above = std::max(slab.above, -drop);
    }
  }

  Point bend_at(std::int64_t x, std::int64_t y, std::int64_t dz) {
    slabs_.left = std::min(slabs_.left, x);
    slabs_.front = std::min(slabs_.front, y);
    return {x, y, dz};
  }

  /// From the stem or station u a lean into the line cross = const through v, then an arm along it
  /// (VA).
  void add_lean_and_arm(NodeId v, LongBends& edge, NodeId u) {
    const std::int64_t along = own_[u] - own_[v];
    const std::int64_t across = cross_[u] - cross_[v];
    const ArmLean shape = arm_and_lean(std::abs(along), std::abs(across));
    add(v, edge, cross_[u], own_[u], shape.total_height());
    add(v, edge, cross_[v], own_[v] + sign_of(along) * shape.arm, shape.arm);
  }

  void add_pole_lean(NodeId t, LongBends& edge, const PoleShape& shape, const PoleLean& lean,
                     int side) {
    add(t, edge, cross_[lean.from], own_[lean.from], lean.height - lean.b);
    add(t, edge, shape.cross - shape.sign * lean.b, shape.own + 2L * side * lean.b, -lean.b);
  }

  void add_special(const Pole& pole, LongBends& edge, const PoleShape& shape) {
    const NodeId t = pole.node;
    const std::int64_t along = std::abs(shape.special_cross - shape.cross);
    if (pole.a_type) {
      add(t, edge, shape.special_cross, shape.own, along);
      return;
    }
    const std::int64_t across = std::abs(own_[pole.special] - shape.own);
    count_excess(own_[pole.special] - own_[t]);
    const ArmLean lean = arm_and_lean(along, across);
    add(t, edge, shape.special_cross, own_[pole.special], lean.total_height());
    add(t, edge, shape.cross + shape.sign * lean.arm, shape.own, lean.arm);
  }

  const View view_;
  const LongVector<PoleShape>& poles_;
  const Values& own_;
  const Values& cross_;
  Slabs& slabs_;
};

/// VV: a lean between the two stems just below the SPLIT.
void draw_vv_lean(const Layout& layout, NodeId m, NodeId s, LongBends& bends, Slabs& slabs) {
  const std::int32_t dx = layout.columns[s] - layout.columns[m];
  const std::int32_t dy = layout.rows[s] - layout.rows[m];
  if (dx == 0 && dy == 0) return;  // straight
  const std::int64_t below = lean_height(dx, dy) + 1;
  bends.add_upper({layout.columns[m], layout.rows[m], -below});
  bends.add_upper({layout.columns[s], layout.rows[s], -1});
  slabs.of_node[s].below = below;
}

}  // namespace

Slabs draw_slabs(const Flow& flow, const Layout& layout, Output& output) {
  Slabs slabs;
  slabs.of_node.resize(flow.nodes.size());
  ViewSlabs rows(View(flow, false), layout, slabs);
  ViewSlabs columns(View(flow, true), layout, slabs);
  for (LongId e = 0; e < flow.edges.size(); ++e) {
    const auto [lower, upper, first_edge] = flow.edges[e];
    if (e + kAhead < flow.edges.size()) {
      const NodeId ahead = flow.edges[e + kAhead].upper;
      prefetch(layout.rows, ahead);
      prefetch(layout.columns, ahead);
      prefetch(slabs.of_node, ahead);
      prefetch(flow.types[0], ahead);
      prefetch(flow.types[1], ahead);
      output.prefetch_bends(flow.edges[e + kAhead].first_edge);
    }
    LongBends bends;
    columns.draw_end(bends, lower, upper);
    rows.draw_end(bends, upper, lower);
    if (flow.is_vv_edge(e)) draw_vv_lean(layout, lower, upper, bends, slabs);
    output.bends(first_edge) = bends;
  }
  return slabs;
}

}  // namespace ar3d::two_bend
