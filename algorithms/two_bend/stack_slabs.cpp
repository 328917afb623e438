// Step 2.11: slabs stacked in time order, then all points written. Vertices of degree 1 and 2 stand
// on the bends of their edge where it has any: that saves the bend and a slab. Cost: O(n).
#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "ar3d/algorithms/two_bend/fixed_bodies.h"
#include "ar3d/algorithms/two_bend/slab.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

/// Works on places in the time order.
class Writer {
 public:
  Writer(const Component& component, Output& output)
      : in_(component),
        output_(output),
        xy_(component.order.list.size()),
        z_(component.order.list.size(), 0) {}

  void run() {
    mark_bodies();
    count_passes();
    place_nodes();
    place_ends();
    place_heights();
    find_corner();
    output_.make_room(in_.graph.size(), top_);
    for (LongId e = 0; e < in_.flow.edges.size(); ++e) {
      ask_for_edge(e);
      write_edge(e);
    }
    for (std::uint32_t i = 0; i < z_.size(); ++i) {
      if (i + 2 * kAhead < z_.size()) {
        ask_for(in_.graph.name, in_.order.list[i + 2 * kAhead]);
        output_.ask_for_vertex(in_.graph.name[in_.order.list[i + kAhead]]);
      }
      output_.set_vertex(in_.graph.name[in_.order.list[i]], point_at(i));
    }
    for (const QBody& body : in_.bodies) {
      const std::uint32_t i = in_.flow.place[body.joint];
      draw_q_body(in_.graph, body, point_at(i), is_end(i), output_);
    }
    output_.end_component(top_);
  }

 private:
  /// Rows and columns are below kMaxHorizontal, and so is what is found from them.
  static FlatPoint flat(std::int64_t x, std::int64_t y) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
    expect(std::max(std::abs(x), std::abs(y)) <= kMost, "rows and columns fit 32 bits");
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  }

  NodeId node_at(std::uint32_t place) const { return in_.flow.element[place]; }
  std::uint32_t place_of(NodeId v) const { return in_.flow.nodes[v].place; }
  NodeType type(NodeId v) const { return in_.flow.types[0][v]; }
  Point point_at(std::uint32_t i) const { return {xy_[i].x - left_, xy_[i].y - front_, z_[i]}; }

  /// A joint of a Q body has degree 1: below an END hangs its bridge, so its body stands above.
  bool is_end(std::uint32_t joint) const { return type(node_at(joint)) == NodeType::end; }

  void mark_bodies() {
    has_body_.assign(z_.size(), false);
    for (const QBody& body : in_.bodies) has_body_[in_.flow.place[body.joint]] = true;
  }

  void count_passes() {
    passes_.assign(in_.flow.nodes.size() < z_.size() ? in_.flow.edges.size() : 0, 0);
    for (std::uint32_t i = 0; !passes_.empty() && i < z_.size(); ++i) {
      if (in_.flow.is_pass[i]) ++passes_[in_.flow.element[i]];
    }
  }

  void place_nodes() {
    for (NodeId v = 0; v < in_.flow.nodes.size(); ++v) {
      FlatPoint& p = xy_[place_of(v)];
      p = {in_.layout.columns[v], in_.layout.rows[v]};
      if (in_.flow.pole_of[v] == kNone) continue;
      const PoleShape& shape = in_.layout.poles[in_.flow.pole_of[v]];
      p = type(v) == NodeType::sink ? flat(shape.cross, shape.own) : flat(shape.own, shape.cross);
    }
  }

  /// Vertices of degree 1 stand on the ray of their edge, until they get a bend of it.
  void place_ends() {
    on_bend_.assign(in_.flow.nodes.size(), false);
    for (LongId e = 0; e < in_.flow.edges.size(); ++e) {
      const LongEdge& edge = in_.flow.edges[e];
      const bool starts = type(edge.lower) == NodeType::start;
      const bool ends = type(edge.upper) == NodeType::end;
      if (!starts && !ends) continue;
      const FlatPoint ray = ray_of(in_.flow, in_.layout, edge);
      if (starts) xy_[place_of(edge.lower)] = ray;
      if (ends) xy_[place_of(edge.upper)] = ray;
      if (stands_free(edge.lower)) on_bend_[edge.lower] = bend_under(e, 0);
      if (stands_free(edge.upper)) on_bend_[edge.upper] = bend_under(e, standing(e) - 1);
    }
  }

  /// A vertex of degree 1 needs no direction, so it may stand on a bend, unless a Q body hangs on
  /// it.
  bool stands_free(NodeId v) const {
    return (type(v) == NodeType::start || type(v) == NodeType::end) && !has_body_[place_of(v)];
  }

  /// Vertices on a long edge that may stand on bends: at a PASS 120 degrees are enough.
  std::size_t standing(LongId e) const {
    return std::size_t{passes_.empty() ? 0 : passes_[e]} + stands_free(in_.flow.edges[e].lower) +
           stands_free(in_.flow.edges[e].upper);
  }

  /// True if the k-th of the vertices on a long edge, upwards, stands on a bend: the first ones on
  /// the lower bends and the last ones on the upper bends, as far as they go.
  bool bend_under(LongId e, std::size_t k) const {
    const LongBends& bends = in_.slabs.of_edge[e];
    const std::size_t all = standing(e);
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
        if (bend_under(e, passed[e]++ + stands_free(in_.flow.edges[e].lower))) continue;
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
      if (!in_.flow.is_pass[i]) include(xy_[i].x, xy_[i].y);
    }
    for (const QBody& body : in_.bodies) {
      const std::uint32_t i = in_.flow.place[body.joint];
      include(xy_[i].x - (is_end(i) ? 0 : kQHalfWidth), xy_[i].y - (is_end(i) ? kQHalfWidth : 0));
    }
  }

  /// All bends of a long edge, upwards.
  std::array<Point, 2> bends_of(LongId e) const {
    const LongEdge& edge = in_.flow.edges[e];
    const LongBends& bends = in_.slabs.of_edge[e];
    std::array<Point, 2> points;
    for (std::size_t i = 0; i < bends.count(); ++i) {
      const RelativeBend bend = bends[i];
      const std::int64_t z = z_[place_of(i < bends.lower_count() ? edge.lower : edge.upper)];
      points[i] = {bend.x - left_, bend.y - front_, z + bend.dz};
    }
    return points;
  }

  /// Asks memory for what edges soon to be written need.
  [[gnu::always_inline]] void ask_for_edge(LongId e) const {
    const auto& edges = in_.flow.edges;
    if (e + 2 * kAhead >= edges.size()) return;
    ask_for(in_.flow.nodes, edges[e + 2 * kAhead].upper);
    ask_for(z_, place_of(edges[e + kAhead].upper));
    output_.ask_for_bends(edges[e + kAhead].first_edge);
  }

  void write_edge(LongId e) {
    const LongEdge& edge = in_.flow.edges[e];
    const std::array<Point, 2> points = bends_of(e);
    if (standing(e) == 0) {
      output_.set_bends(edge.first_edge, {points.data(), in_.slabs.of_edge[e].count()});
    } else {
      write_chain(e, points);
    }
  }

  /// Vertices of degree 1 and 2 on the edge stand on its bends; the bends that are left go to the
  /// chain's last input edge. All other PASS vertices stand on the ray between.
  void write_chain(LongId e, const std::array<Point, 2>& points) {
    const LongEdge& edge = in_.flow.edges[e];
    const FlatPoint ray = ray_of(in_.flow, in_.layout, edge);
    std::size_t k = 0;
    std::size_t used = 0;
    const auto stand_on_bend = [&](std::uint32_t i) {
      if (!bend_under(e, k++)) return false;
      stand_on(i, points[used++]);
      return true;
    };
    if (stands_free(edge.lower)) stand_on_bend(place_of(edge.lower));
    std::uint32_t i = edge.first;
    EdgeId id = edge.first_edge;
    for (const std::uint32_t top = place_of(edge.upper); i != top;) {
      if (!stand_on_bend(i)) xy_[i] = ray;
      output_.set_bends(id, {});
      const Vertex v = in_.order.list[i];
      const std::size_t other = in_.graph.edges[v][0] == id ? 1 : 0;
      id = in_.graph.edges[v][other];
      i = in_.flow.place[in_.graph.neighbours[v].to[other]];
    }
    std::size_t last = in_.slabs.of_edge[e].count();
    if (stands_free(edge.upper) && bend_under(e, k)) stand_on(i, points[--last]);
    output_.set_bends(id, {points.data() + used, last - used});
  }

  void stand_on(std::uint32_t i, const Point& bend) {
    xy_[i] = flat(bend.x + left_, bend.y + front_);
    z_[i] = bend.z;
  }

  const Component& in_;
  Output& output_;
  LongVector<FlatPoint> xy_;          // per place
  LongVector<std::int64_t> z_;        // per place
  std::vector<bool> has_body_;        // per place
  LongVector<std::uint32_t> passes_;  // per long edge; empty if there is none
  std::vector<bool> on_bend_;         // per node
  std::int64_t left_ = 0;             // least x and y: the origin of what is written
  std::int64_t front_ = 0;
  std::int64_t top_ = 0;
};

}  // namespace

void stack_slabs(const Component& component, Output& output) { Writer(component, output).run(); }

}  // namespace ar3d::two_bend
