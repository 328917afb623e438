// Step 2.11: slabs stacked in time order, then all points written. Vertices of degree 1 and 2 stand
// on the bends of their edge where it has any: that saves the bend and a slab. Cost: O(n).
#include <algorithm>
#include <array>

#include "ar3d/algorithms/two_bend/slab.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

/// Works on indices in the time order.
class Writer {
 public:
  Writer(const LocalGraph& graph, const LongVector<Vertex>& order, const Attempt& attempt,
         const LongVector<QBody>& bodies, Output& output)
      : graph_(graph),
        order_(order),
        in_(attempt),
        bodies_(bodies),
        output_(output),
        xy_(order.size()),
        z_(order.size(), 0) {}

  void run() {
    mark_bodies();
    count_passes();
    place_nodes();
    if (!in_.flow.joint) place_ends();
    place_heights();
    find_corner();
    output_.make_room(graph_.size(), top_);
    for (LongId e = 0; e < in_.flow.edges.size(); ++e) {
      prefetch_edge(e);
      write_edge(e);
    }
    for (std::uint32_t i = 0; i < z_.size(); ++i) {
      if (i + 2 * kAhead < z_.size()) {
        prefetch(graph_.name, order_[i + 2 * kAhead]);
        output_.prefetch_vertex(graph_.name[order_[i + kAhead]]);
      }
      output_.set_vertex(graph_.name[order_[i]], point_at(i));
    }
    for (const QBody& body : bodies_) {
      const std::uint32_t i = in_.flow.index[body.joint];
      draw_q_body(graph_, body, point_at(i), is_end(i), output_);
    }
    output_.end_component(top_);
  }

 private:
  /// Rows and columns are below kMaxHorizontal, and so is what is found from them.
  void stand_at(std::uint32_t i, std::int64_t x, std::int64_t y) {
    expect(std::in_range<std::int32_t>(x) && std::in_range<std::int32_t>(y),
           "rows and columns fit 32 bits");
    xy_[i] = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  }

  NodeId node_at(std::uint32_t index) const { return in_.flow.node_at(index); }
  std::uint32_t index_of(NodeId v) const { return in_.flow.index_of(v); }
  NodeType type(NodeId v) const { return in_.flow.types[0][v]; }
  Point point_at(std::uint32_t i) const { return {xy_[i][0] - left_, xy_[i][1] - front_, z_[i]}; }

  /// A joint of a Q body has degree 1: below an END hangs its bridge, so its body stands above.
  bool is_end(std::uint32_t joint) const { return type(node_at(joint)) == NodeType::end; }

  void mark_bodies() {
    has_body_.assign(z_.size(), false);
    for (const QBody& body : bodies_) has_body_[in_.flow.index[body.joint]] = true;
  }

  void count_passes() {
    passes_.assign(in_.flow.nodes.size() < z_.size() ? in_.flow.edges.size() : 0, 0);
    for (std::uint32_t i = 0; !passes_.empty() && i < z_.size(); ++i) {
      if (in_.flow.is_pass[i]) ++passes_[in_.flow.element[i]];
    }
  }

  void place_nodes() {
    on_bend_.assign(in_.flow.nodes.size(), false);
    for (NodeId v = 0; v < in_.flow.nodes.size(); ++v) {
      xy_[index_of(v)] = {in_.layout.columns[v], in_.layout.rows[v]};
    }
    for (std::size_t i = 0; i < in_.flow.poles.size(); ++i) {
      const NodeId v = in_.flow.poles[i].node;
      const PoleShape& shape = in_.layout.poles[i];
      const bool is_sink = type(v) == NodeType::sink;
      stand_at(index_of(v), is_sink ? shape.cross : shape.own, is_sink ? shape.own : shape.cross);
    }
  }

  /// Vertices of degree 1 stand on the ray of their edge, until they get a bend of it.
  void place_ends() {
    for (LongId e = 0; e < in_.flow.edges.size(); ++e) {
      const LongEdge& edge = in_.flow.edges[e];
      const bool starts = type(edge.lower) == NodeType::start;
      const bool ends = type(edge.upper) == NodeType::end;
      if (!starts && !ends) continue;
      const Point ray = ray_of(in_.flow, in_.layout, edge);
      if (starts) stand_at(index_of(edge.lower), ray.x, ray.y);
      if (ends) stand_at(index_of(edge.upper), ray.x, ray.y);
      const LongBends& bends = output_.bends(edge.first_edge);
      const std::size_t all = standing(e);
      if (stands_free(edge.lower)) on_bend_[edge.lower] = bend_under(bends, all, 0);
      if (stands_free(edge.upper)) on_bend_[edge.upper] = bend_under(bends, all, all - 1);
    }
  }

  /// A vertex of degree 1 needs no direction, so it may stand on a bend, unless a Q body hangs on
  /// it.
  bool stands_free(NodeId v) const {
    return (type(v) == NodeType::start || type(v) == NodeType::end) && !has_body_[index_of(v)];
  }

  /// Vertices on a long edge that may stand on bends: at a PASS 120 degrees are enough.
  std::size_t standing(LongId e) const {
    return std::size_t{passes_.empty() ? 0 : passes_[e]} + stands_free(in_.flow.edges[e].lower) +
           stands_free(in_.flow.edges[e].upper);
  }

  /// True if the k-th of `all` vertices on a long edge, upwards, stands on a bend: the first ones
  /// on the lower bends and the last ones on the upper bends, as far as they go.
  static bool bend_under(const LongBends& bends, std::size_t all, std::size_t k) {
    return all <= bends.count() || k < bends.lower_count() || all - k <= bends.upper_count();
  }

  /// Stacks the slabs in time order (Step 2.11). A vertex that is not alone in its slab and would
  /// have an empty one stands on a bend instead.
  void place_heights() {
    LongVector<std::uint32_t> passed(passes_.size(), 0);  // per long edge
    std::int64_t next = output_.base_z();
    for (std::uint32_t i = 0; i < z_.size(); ++i) {
      SlabHeights slab;
      if (in_.flow.is_pass[i]) {
        const LongId e = in_.flow.element[i];
        const LongEdge& edge = in_.flow.edges[e];
        const std::size_t k = passed[e]++ + stands_free(edge.lower);
        if (bend_under(output_.bends(edge.first_edge), standing(e), k)) continue;
      } else {
        if (on_bend_[node_at(i)]) continue;
        slab = in_.slabs.of_node[node_at(i)];
        if (has_body_[i]) (is_end(i) ? slab.above : slab.below) = kQHeight;
      }
      z_[i] = next + slab.below;
      top_ = z_[i] + slab.above;
      next = top_ + 1;
      expect(next < kMaxCoordinate, "heights fit the largest coordinate");
    }
  }

  /// The least x and y of nodes, bends and Q bodies: what is drawn is moved by them.
  void find_corner() {
    left_ = in_.slabs.left;
    front_ = in_.slabs.front;
    const auto include = [&](std::int64_t x, std::int64_t y) {
      left_ = std::min(left_, x);
      front_ = std::min(front_, y);
    };
    for (std::uint32_t i = 0; i < z_.size(); ++i) {
      if (!in_.flow.is_pass[i]) include(xy_[i][0], xy_[i][1]);
    }
    for (const QBody& body : bodies_) {
      const std::uint32_t i = in_.flow.index[body.joint];
      include(xy_[i][0] - (is_end(i) ? 0 : kQHalfWidth), xy_[i][1] - (is_end(i) ? kQHalfWidth : 0));
    }
  }

  /// Prefetches what edges soon to be written need.
  [[gnu::always_inline]] void prefetch_edge(LongId e) const {
    const auto& edges = in_.flow.edges;
    if (e + kAhead >= edges.size()) return;
    prefetch(z_, index_of(edges[e + kAhead].upper));
    output_.prefetch_bends(edges[e + kAhead].first_edge);
  }

  void write_edge(LongId e) {
    const LongEdge& edge = in_.flow.edges[e];
    LongBends& bends = output_.bends(edge.first_edge);
    std::array<Point, 2> points;
    for (std::size_t i = 0; i < bends.count(); ++i) {
      const std::int64_t z = z_[index_of(i < bends.lower_count() ? edge.lower : edge.upper)];
      points[i] = bends[i] + Vector{-left_, -front_, z};
    }
    if (in_.flow.joint || standing(e) == 0) {
      for (std::size_t i = 0; i < bends.count(); ++i) bends.set(i, points[i]);
    } else {
      write_chain(e, LongBends(bends), points);
    }
  }

  /// Vertices of degree 1 and 2 on the edge stand on its bends; the bends that are left go to the
  /// chain's last input edge. All other PASS vertices stand on the ray between.
  /// @param bends  a copy, since the output's are written.
  void write_chain(LongId e, const LongBends& bends, const std::array<Point, 2>& points) {
    const LongEdge& edge = in_.flow.edges[e];
    const Point ray = ray_of(in_.flow, in_.layout, edge);
    const std::size_t all = standing(e);
    std::size_t k = 0;
    std::size_t used = 0;
    const auto stand_on_bend = [&](std::uint32_t i) {
      if (!bend_under(bends, all, k++)) return false;
      stand_on(i, points[used++]);
      return true;
    };
    std::uint32_t i = index_of(edge.lower);
    if (stands_free(edge.lower)) stand_on_bend(i);
    EdgeId id = edge.first_edge;
    const auto& edges = graph_.edges[order_[i]];
    i = end_of(i,
               static_cast<std::size_t>(std::find(edges.begin(), edges.end(), id) - edges.begin()));
    for (const std::uint32_t top = index_of(edge.upper); i != top;) {
      if (!stand_on_bend(i)) stand_at(i, ray.x, ray.y);
      output_.set_bends(id, {});
      const auto& both = graph_.edges[order_[i]];
      const std::size_t other = both[0] == id ? 1 : 0;
      id = both[other];
      i = end_of(i, other);
    }
    std::size_t last = bends.count();
    if (stands_free(edge.upper) && bend_under(bends, all, k)) stand_on(i, points[--last]);
    output_.set_bends(id, {points.data() + used, last - used});
  }

  /// The index of the k-th neighbour of the vertex at an index.
  std::uint32_t end_of(std::uint32_t i, std::size_t k) const {
    return in_.flow.index[graph_.neighbours[order_[i]].to[k]];
  }

  void stand_on(std::uint32_t i, const Point& bend) {
    stand_at(i, bend.x + left_, bend.y + front_);
    z_[i] = bend.z;
  }

  const LocalGraph& graph_;
  const LongVector<Vertex>& order_;
  const Attempt& in_;
  const LongVector<QBody>& bodies_;
  Output& output_;
  LongVector<std::array<std::int32_t, 2>> xy_;  // per index
  LongVector<std::int64_t> z_;                  // per index
  std::vector<bool> has_body_;                  // per index
  LongVector<std::uint32_t> passes_;            // per long edge; empty if there is none
  std::vector<bool> on_bend_;                   // per node
  std::int64_t left_ = 0;                       // least x and y: the origin of what is written
  std::int64_t front_ = 0;
  std::int64_t top_ = 0;
};

}  // namespace

void stack_slabs(const LocalGraph& graph, const LongVector<Vertex>& order, const Attempt& attempt,
                 const LongVector<QBody>& bodies, Output& output) {
  Writer(graph, order, attempt, bodies, output).run();
}

}  // namespace ar3d::two_bend
