#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/verify/certificate.h"

namespace ar3d::testing {

/// A drawing that tests put together and break: everything is public and may be wrong.
struct Draft {
  struct DraftEdge {
    Edge ends;
    std::vector<Point> bends;
  };
  std::vector<Point> vertices;
  std::vector<DraftEdge> edges;
  Lattice lattice = kCubeLattice;
  std::string algorithm = "draft";

  Drawing drawing() const {
    Coordinates places(vertices.size(), kMaxCoordinate);
    for (std::size_t v = 0; v < vertices.size(); ++v) places.set(v, vertices[v]);
    auto ends = std::make_shared<std::vector<Edge>>();
    auto bends = std::make_shared<StoredBends>();
    for (const DraftEdge& edge : edges) {
      ends->push_back(edge.ends);
      bends->add_edge(edge.bends);
    }
    return Drawing(algorithm, lattice, std::move(places), std::move(ends), std::move(bends));
  }
  /// The graph that the draft draws, which must be simple.
  Graph graph() const {
    std::vector<Edge> ends;
    for (const DraftEdge& edge : edges) ends.push_back(edge.ends);
    return Graph(vertices.size(), std::move(ends));
  }
};

/// The drawing, moved by `by`.
inline Draft draft_of(const Drawing& drawing, Vector by = {}) {
  Draft draft;
  draft.lattice = drawing.lattice();
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) {
    draft.vertices.push_back(drawing.vertex(v) + by);
  }
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    draft.edges.push_back({drawing.edge(e), {points.begin() + 1, points.end() - 1}});
    for (Point& bend : draft.edges.back().bends) bend = bend + by;
  });
  return draft;
}

/// Promises nothing but that nothing meets.
inline Guarantee no_promise() {
  Guarantee guarantee;
  guarantee.max_degree = guarantee.max_bends = 1u << 30;
  guarantee.angle_rule = AngleRule::at_least;
  guarantee.cosine = {1, 1};
  return guarantee;
}

}  // namespace ar3d::testing
