#include "ar3d/algorithms/two_bend/sweep.h"

#include <algorithm>
#include <array>

#include "ar3d/algorithms/two_bend/fixed_bodies.h"
#include "ar3d/model/error.h"

namespace ar3d::two_bend {
namespace {

class Sweep {
 public:
  Sweep(const Component& component, Output& output)
      : in_(component), output_(output), at_(component.graph.size()) {}

  void run() {
    count_standing();
    place_nodes();
    place_heights();
    translate();
    for (LongId e = 0; e < in_.flow.edges.size(); ++e) write_edge(e);
    for (const Vertex v : in_.order.list) output_.set_vertex(in_.graph.name[v], at_[v]);
    for (const QBody& body : in_.bodies) {
      draw_q_body(in_.graph, body, at_[body.joint], is_end(body.joint), output_);
    }
    output_.end_component(top_);
  }

 private:
  NodeId node_at(std::size_t place) const { return in_.flow.element[place]; }
  Vertex vertex_of(NodeId v) const { return in_.flow.nodes[v].vertex; }

  /// A joint of a Q body has degree 1: below an END hangs its bridge, so its body stands above.
  bool is_end(Vertex joint) const { return ends_[joint]; }

  void place_nodes() {
    for (NodeId v = 0; v < in_.flow.nodes.size(); ++v) {
      const Node& node = in_.flow.nodes[v];
      Point& p = at_[node.vertex];
      p.x = in_.layout.columns[v];
      p.y = in_.layout.rows[v];
      if (node.type == NodeType::start || node.type == NodeType::end) {
        const Ray ray = ray_of(in_.flow, in_.layout, in_.flow.edges[node.edge[0]]);
        p.x = ray.x;
        p.y = ray.y;
      } else if (node.type == NodeType::sink || node.type == NodeType::source) {
        const PoleShape& shape = in_.layout.poles[in_.flow.pole_of[v]];
        const bool is_sink = node.type == NodeType::sink;
        p.x = is_sink ? shape.cross : shape.own;
        p.y = is_sink ? shape.own : shape.cross;
      }
    }
  }

  /// A vertex of degree 1 needs no direction, so it may stand on a bend, unless a Q body hangs on
  /// it.
  bool stands_free(NodeId v) const {
    const Node& node = in_.flow.nodes[v];
    return (node.type == NodeType::start || node.type == NodeType::end) && !has_body_[node.vertex];
  }

  /// Vertices on long edges that may stand on bends: at a PASS 120 degrees are enough.
  void count_standing() {
    has_body_.assign(in_.graph.size(), false);
    for (const QBody& body : in_.bodies) has_body_[body.joint] = true;
    standing_.assign(in_.flow.edges.size(), 0);
    for (std::size_t i = 0; i < in_.flow.is_pass.size(); ++i) {
      if (in_.flow.is_pass[i]) ++standing_[in_.flow.element[i]];
    }
    for (LongId e = 0; e < in_.flow.edges.size(); ++e) {
      standing_[e] += stands_free(in_.flow.edges[e].lower) + stands_free(in_.flow.edges[e].upper);
    }
  }

  /// Whether the k-th of the vertices on a long edge, upwards, stands on a bend: the first ones on
  /// the lower bends and the last ones on the upper bends, as far as they go.
  bool bend_under(LongId e, std::size_t k) const {
    const LongBends& bends = in_.slabs.of_edge[e];
    const std::size_t all = standing_[e];
    return all <= bends.count() || k < bends.lower_count || all - k <= bends.upper_count;
  }

  /// Whether a vertex that is not alone in its slab would have an empty one: it stands on a bend.
  bool needs_slab(std::size_t place) {
    if (in_.flow.is_pass[place]) {
      const LongId e = in_.flow.element[place];
      return !bend_under(e, passed_[e]++ + stands_free(in_.flow.edges[e].lower));
    }
    const NodeId v = node_at(place);
    if (!stands_free(v)) return true;
    const LongId e = in_.flow.nodes[v].edge[0];
    return !bend_under(e, in_.flow.edges[e].lower == v ? 0 : standing_[e] - 1);
  }

  /// Stacks the slabs in time order (R19).
  void place_heights() {
    passed_.assign(in_.flow.edges.size(), 0);
    ends_.assign(in_.graph.size(), false);
    std::int64_t next = output_.base_z();
    for (std::size_t i = 0; i < in_.order.list.size(); ++i) {
      const Vertex v = in_.order.list[i];
      Slab slab;
      if (!in_.flow.is_pass[i]) {
        slab = in_.slabs.of_node[node_at(i)];
        ends_[v] = in_.flow.nodes[node_at(i)].type == NodeType::end;
        if (has_body_[v]) (ends_[v] ? slab.above : slab.below) = kQHeight;
      }
      if (!needs_slab(i)) continue;
      at_[v].z = next + slab.below;
      top_ = at_[v].z + slab.above;
      next = top_ + 1;
      expect(next < kMaxCoordinate, "heights fit the largest coordinate");
    }
  }

  void translate() {
    std::int64_t x = at_[in_.order.list.front()].x;
    std::int64_t y = at_[in_.order.list.front()].y;
    const auto include = [&](std::int64_t px, std::int64_t py) {
      x = std::min(x, px);
      y = std::min(y, py);
    };
    for (const Node& node : in_.flow.nodes) include(at_[node.vertex].x, at_[node.vertex].y);
    for (const LongBends& edge : in_.slabs.of_edge) {
      for (std::size_t i = 0; i < edge.lower_count + edge.upper_count; ++i) {
        include(edge.bends[i].x, edge.bends[i].y);
      }
    }
    for (const QBody& body : in_.bodies) {
      const Point p = at_[body.joint];
      include(p.x - (is_end(body.joint) ? 0 : kQHalfWidth),
              p.y - (is_end(body.joint) ? kQHalfWidth : 0));
    }
    left_ = x;
    front_ = y;
    for (const Node& node : in_.flow.nodes) {
      at_[node.vertex].x -= x;
      at_[node.vertex].y -= y;
    }
  }

  Point bend_at(const RelativeBend& bend, Vertex end) const {
    return {bend.x - left_, bend.y - front_, at_[end].z + bend.dz};
  }

  /// All bends of a long edge, upwards.
  std::array<Point, 2> bends_of(LongId e) const {
    const LongEdge& edge = in_.flow.edges[e];
    const LongBends& bends = in_.slabs.of_edge[e];
    std::array<Point, 2> points;
    for (std::size_t i = 0; i < bends.count(); ++i) {
      points[i] =
          bend_at(bends.bends[i], vertex_of(i < bends.lower_count ? edge.lower : edge.upper));
    }
    return points;
  }

  /// Vertices of degree 1 and 2 on the edge stand on its bends; the bends that are left go to the
  /// chain's last input edge. All other PASS vertices stand on the ray between.
  void write_edge(LongId e) {
    const LongEdge& edge = in_.flow.edges[e];
    const std::array<Point, 2> points = bends_of(e);
    const Ray ray = ray_of(in_.flow, in_.layout, edge);
    Vertex from = vertex_of(edge.lower);
    std::size_t k = 0;
    std::size_t used = 0;
    const auto stand_on_bend = [&](Vertex v) {
      if (!bend_under(e, k++)) return false;
      at_[v] = points[used++];
      return true;
    };
    if (stands_free(edge.lower)) stand_on_bend(from);
    Vertex v = edge.first;
    EdgeId id = edge.first_edge;
    for (const Vertex top = vertex_of(edge.upper); v != top;) {
      if (!stand_on_bend(v)) at_[v] = {ray.x - left_, ray.y - front_, at_[v].z};
      write_bends(id, from, points, 0, 0);
      from = v;
      const std::size_t other = in_.graph.edges[v][0] == id ? 1 : 0;
      id = in_.graph.edges[v][other];
      v = in_.graph.rows[v].to[other];
    }
    std::size_t last = in_.slabs.of_edge[e].count();
    if (stands_free(edge.upper) && bend_under(e, k)) at_[v] = points[--last];
    write_bends(id, from, points, used, last);
  }

  void write_bends(EdgeId id, Vertex from, const std::array<Point, 2>& points, std::size_t begin,
                   std::size_t end) {
    output_.set_bends(id, in_.graph.name[from], {points.data() + begin, end - begin});
  }

  const Component& in_;
  Output& output_;
  std::vector<Point> at_;
  std::vector<bool> ends_;
  std::vector<bool> has_body_;
  std::vector<std::uint32_t> standing_;  // per long edge
  std::vector<std::uint32_t> passed_;    // per long edge: its PASS vertices met so far
  std::int64_t left_ = 0;
  std::int64_t front_ = 0;
  std::int64_t top_ = 0;
};

}  // namespace

void sweep(const Component& component, Output& output) { Sweep(component, output).run(); }

}  // namespace ar3d::two_bend
