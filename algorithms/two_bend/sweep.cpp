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
    place_nodes();
    place_heights();
    translate();
    for (const LongEdge& edge : in_.flow.edges) write_edge(edge);
    for (const Vertex v : in_.order.list) output_.set_vertex(in_.graph.name[v], at_[v]);
    for (const QBody& body : in_.bodies) {
      draw_q_body(in_.graph, body, at_[body.joint], is_end(body.joint), output_);
    }
    output_.end_component(top_);
  }

 private:
  NodeId node_at(std::size_t place) const { return in_.flow.element[place]; }

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

  /// Stacks the slabs in time order (R19).
  void place_heights() {
    std::vector<bool> has_body(in_.graph.size(), false);
    for (const QBody& body : in_.bodies) has_body[body.joint] = true;
    ends_.assign(in_.graph.size(), false);
    std::int64_t next = output_.base_z();
    for (std::size_t i = 0; i < in_.order.list.size(); ++i) {
      const Vertex v = in_.order.list[i];
      Slab slab;
      if (!in_.flow.is_pass[i]) {
        slab = in_.slabs.of_node[node_at(i)];
        ends_[v] = in_.flow.nodes[node_at(i)].type == NodeType::end;
        if (has_body[v]) (ends_[v] ? slab.above : slab.below) = kQHeight;
      }
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

  /// Lower bends go to the chain's first edge, upper bends to its last; PASS vertices stand on the
  /// ray between.
  void write_edge(const LongEdge& edge) {
    const LongBends& bends =
        in_.slabs.of_edge[static_cast<std::size_t>(&edge - in_.flow.edges.data())];
    const Vertex top = in_.flow.nodes[edge.upper].vertex;
    const Ray ray = ray_of(in_.flow, in_.layout, edge);
    std::array<Point, 2> points;
    std::size_t count = 0;
    Vertex from = in_.flow.nodes[edge.lower].vertex;
    for (; count < bends.lower_count; ++count) points[count] = bend_at(bends.bends[count], from);
    Vertex v = edge.first;
    EdgeId id = edge.first_edge;
    while (v != top) {
      at_[v].x = ray.x - left_;
      at_[v].y = ray.y - front_;
      write_bends(id, from, points, count);
      count = 0;
      from = v;
      const Row& row = in_.graph.rows[v];
      const std::size_t k = row.edge[0] == id ? 1 : 0;
      v = row.to[k];
      id = row.edge[k];
    }
    for (std::size_t i = 0; i < bends.upper_count; ++i) {
      points[count++] = bend_at(bends.bends[bends.lower_count + i], top);
    }
    write_bends(id, from, points, count);
  }

  void write_bends(EdgeId id, Vertex from, const std::array<Point, 2>& points, std::size_t count) {
    output_.set_bends(id, in_.graph.name[from], {points.data(), count});
  }

  const Component& in_;
  Output& output_;
  std::vector<Point> at_;
  std::vector<bool> ends_;
  std::int64_t left_ = 0;
  std::int64_t front_ = 0;
  std::int64_t top_ = 0;
};

}  // namespace

void sweep(const Component& component, Output& output) { Sweep(component, output).run(); }

}  // namespace ar3d::two_bend
