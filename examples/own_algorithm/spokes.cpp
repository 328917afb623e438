#include "spokes.h"

#include <vector>

#include "ar3d/base/error.h"

namespace spokes {
namespace {

using namespace ar3d;

// Path number y: its middle, if it has one, at x = 1, its ends at 0 and 2.
Drawing draw(const Graph& graph, const Settings&) {
  std::vector<Point> points(graph.num_vertices());
  std::int64_t y = 0;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    if (graph.degree(v) == 0) points[v] = {0, y++, 0};
    if (graph.degree(v) == 2) {
      for (const HalfEdge& half : graph.incident(v)) {
        if (graph.degree(half.to) == 2) throw InputError("spokes: a path of more than two edges");
      }
      points[v] = {1, y, 0};
      points[graph.incident(v)[0].to] = {0, y, 0};
      points[graph.incident(v)[1].to] = {2, y++, 0};
    }
  }
  for (const Edge& edge : graph.edges()) {
    if (graph.degree(edge.u) == 1 && graph.degree(edge.v) == 1) {
      points[edge.u] = {0, y, 0};
      points[edge.v] = {1, y++, 0};
    }
  }
  return drawing_from_points("spokes", graph, points);
}

}  // namespace

Algorithm algorithm() {
  Guarantee guarantee;
  guarantee.max_degree = 2;
  guarantee.max_bends = 0;
  guarantee.cosine = {-1, 1};  // 180 degrees
  guarantee.lattice = kCubeLattice;
  guarantee.directions = {{1, 0, 0}};
  guarantee.vertices_in_plane = true;
  guarantee.bound = {
      "by construction", "examples/own_algorithm", {linear(0) + 2, linear(1), linear(0) + 1}};
  return {"spokes", "short paths side by side", "none", guarantee, {}, draw};
}

Family family() {
  return {"short-paths",
          "Disjoint paths of three vertices",
          2,
          false,
          {},
          [](std::uint64_t n, const Settings&) { return n < 3 ? 3 : n / 3 * 3; },
          [](std::uint64_t n, std::uint64_t, const Settings&) {
            std::vector<Edge> edges;
            for (std::uint64_t v = 0; v < n; v += 3) {
              const auto first = static_cast<Vertex>(v);
              edges.push_back({first, first + 1});
              edges.push_back({first + 1, first + 2});
            }
            return Graph(n, std::move(edges));
          }};
}

Metric metric() {
  return {"segments", "1", "segments of positive length", MetricType::int64,
          [](const DrawingSummary& summary) {
            return MetricValue(static_cast<std::int64_t>(summary.segments));
          }};
}

}  // namespace spokes
