// Step G.1 and what all steps share: points, polylines, the front that they push, and components
// side by side (Repair G.2). Coordinates are the paper's skewed ones until the drawing is finished.
// Cost: O(1) a vertex and edge.
#include "ar3d/algorithms/grid_paper/builder.h"

#include <cstdlib>

#include "ar3d/base/error.h"

namespace ar3d::grid_paper {
DrawingBuilder::DrawingBuilder(const Graph& graph, const Options& options,
                               const RepairSwitches& repairs)
    : graph_(graph),
      options_(options),
      repairs_(repairs),
      kind_(graph.num_vertices()),
      at_(graph.num_vertices(), SkewPoint{kNoPlane, 0, 0}),
      bends_(graph.num_edges()),
      layer_of_(graph.num_vertices()) {}

// The first layer has its largest y at 0, and front + 1 is at least 4 right of it, which ways back
// need (Lemma G.3).
void DrawingBuilder::begin_component() {
  next_x_ = 0;
  top_ = old_top_ = layer_z_ = -2;
  front_ = old_front_ = 3;
  left_ = 4;
}

void DrawingBuilder::end_component(const std::vector<Vertex>& vertices) {
  std::int64_t low = at_[vertices[0]].x, high = low;
  const auto for_each_point = [&](auto visit) {
    for (const Vertex v : vertices) {
      visit(at_[v]);
      for (const HalfEdge half : graph_.incident(v)) {
        if (graph_.edge(half.edge).u != v) continue;
        for (SkewPoint& bend : bends_[half.edge]) visit(bend);
      }
    }
  };
  for_each_point([&](const SkewPoint& p) {
    low = std::min(low, p.x);
    high = std::max(high, p.x);
  });
  const std::int64_t move = repairs_.apart ? end_x_ - low : 0;
  for_each_point([&](SkewPoint& p) { p.x += move; });
  end_x_ = high + move + 2;
}

void DrawingBuilder::place(Vertex v, SkewPoint at, VertexKind kind) {
  at_[v] = at;
  kind_[v] = kind;
  front_ = std::max(front_, at.y);
}

void DrawingBuilder::route(Vertex from, Vertex to, std::initializer_list<SkewPoint> bends) {
  const auto incident = graph_.incident(from);
  const auto half = std::ranges::find(incident, to, &HalfEdge::to);
  expect(half != incident.end(), "a route belongs to an edge");
  EdgeBends& kept = bends_[half->edge];
  kept.assign(bends.begin(), bends.end());
  if (from > to) std::reverse(kept.begin(), kept.end());
  for (const SkewPoint& p : bends) front_ = std::max(front_, p.y);
}

Drawing DrawingBuilder::finish() {
  GrowingBox skew;
  std::int64_t largest = 0;
  const auto add = [&](const SkewPoint& p) {
    skew.add({p.x, p.y, p.z});
    const Point c = cartesian(p);
    largest = std::max({largest, std::abs(c.x), std::abs(c.y), std::abs(c.z)});
    return c;
  };
  auto bends = std::make_shared<StoredBends>();
  std::vector<Point> of_edge;
  for (const EdgeBends& kept : bends_) {
    of_edge.clear();
    for (const SkewPoint& p : kept) of_edge.push_back(add(p));
    bends->add_edge(of_edge);
  }
  for (const SkewPoint& p : at_) add(p);
  Coordinates vertices(at_.size(), largest);
  for (Vertex v = 0; v < at_.size(); ++v) vertices.set(v, cartesian(at_[v]));
  Drawing drawing("grid-paper", kCubeLattice, std::move(vertices), graph_.shared_edges(),
                  std::move(bends));
  const auto [x, y, z] = skew.box().extents();
  const CaseCensus& c = census_;
  drawing.counters = {{"skew_x", x},
                      {"skew_y", y},
                      {"skew_z", z},
                      {"cycles", c.cycles},
                      {"on_cycles", c.on_cycles},
                      {"spread", c.spread},
                      {"connections", c.connections},
                      {"middles", c.middles},
                      {"moved", c.moved},
                      {"same_cycle", c.same_cycle},
                      {"three_of_cycle", c.three_of_cycle},
                      {"past_layer", c.past_layer},
                      {"k4s", c.k4s},
                      {"merges", c.merges},
                      {"threes", c.threes},
                      {"ways_down", c.ways_down}};
  return drawing;
}

}  // namespace ar3d::grid_paper
