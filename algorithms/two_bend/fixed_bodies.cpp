// Step 2.1: K4, K3,3 and Q from tables. Their poles cannot have the neighbours that the
// construction needs. The tables were found by search and are certified like any drawing. Cost:
// O(1) per body.
#include <tuple>

#include "ar3d/algorithms/two_bend/slab.h"
#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

EdgeId edge_between(const LocalGraph& graph, Vertex u, Vertex v) {
  const NeighbourList& near = graph.neighbours[u];
  for (std::size_t k = 0; k < near.degree(); ++k) {
    if (near.to[k] == v) return graph.edges[u][k];
  }
  throw InternalError("internal error: a fixed body lacks an edge");
}

/// Two bends from the first to the second vertex of a table.
using TableEdge = std::tuple<std::size_t, std::size_t, std::array<Point, 2>>;

constexpr std::array<Point, 4> kK4Vertices{{{5, 6, 9}, {5, 2, 17}, {9, 2, 5}, {1, 2, 5}}};
constexpr std::array<TableEdge, 6> kK4Edges{{{0, 1, {{{5, 6, 17}, {5, 4, 19}}}},
                                             {0, 2, {{{9, 6, 5}, {10, 4, 4}}}},
                                             {0, 3, {{{1, 6, 5}, {0, 4, 4}}}},
                                             {1, 2, {{{9, 0, 15}, {10, 0, 12}}}},
                                             {2, 3, {{{6, 0, 0}, {4, 0, 0}}}},
                                             {3, 1, {{{0, 0, 12}, {1, 0, 15}}}}}};

constexpr std::array<Point, 6> kK33Vertices{
    {{13, 4, 8}, {0, 2, 13}, {8, 7, 4}, {3, 9, 12}, {9, 6, 1}, {4, 0, 13}}};
constexpr std::array<TableEdge, 9> kK33Edges{{{0, 3, {{{13, 5, 9}, {5, 9, 14}}}},
                                              {0, 4, {{{13, 4, 3}, {11, 5, 0}}}},
                                              {0, 5, {{{13, 3, 9}, {6, 0, 15}}}},
                                              {1, 3, {{{0, 5, 16}, {2, 9, 13}}}},
                                              {1, 4, {{{0, 2, 8}, {7, 5, 0}}}},
                                              {1, 5, {{{0, 1, 14}, {2, 0, 15}}}},
                                              {2, 3, {{{7, 9, 5}, {3, 9, 9}}}},
                                              {2, 4, {{{9, 7, 3}, {9, 7, 2}}}},
                                              {2, 5, {{{6, 3, 6}, {4, 0, 11}}}}}};

/// Draws the table with its vertex i as local vertex vertices[i].
void draw_table(const LocalGraph& graph, std::span<const Vertex> vertices,
                std::span<const Point> points, std::span<const TableEdge> edges, Output& output) {
  output.make_room(vertices.size(), output.base_z() + kFixedBodyBound[2]);
  const Vector up{0, 0, output.base_z()};
  std::int64_t top = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    output.set_vertex(graph.name[vertices[i]], points[i] + up);
    top = std::max(top, points[i].z);
  }
  for (const auto& [u, v, of_table] : edges) {
    std::array<Point, 2> bends{of_table[0] + up, of_table[1] + up};
    if (is_below(points[v], points[u])) std::swap(bends[0], bends[1]);
    output.set_bends(edge_between(graph, vertices[u], vertices[v]), bends);
    top = std::max({top, of_table[0].z, of_table[1].z});
  }
  output.end_component(output.base_z() + top);
}

/// The vertices with the neighbours of vertex 0 last, if the component is K3,3.
std::optional<LongVector<Vertex>> sides_of_k33(const LocalGraph& graph) {
  if (graph.size() != 6) return std::nullopt;
  LongVector<Vertex> result;
  for (Vertex v = 0; v < 6; ++v) {
    if (graph.neighbours[v].degree() != 3) return std::nullopt;
    if (!graph.adjacent(0, v)) result.push_back(v);
  }
  for (const Vertex v : graph.neighbours[0].to) result.push_back(v);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 3; j < 6; ++j) {
      if (!graph.adjacent(result[i], result[j])) return std::nullopt;
    }
  }
  return result;
}

/// A point of the Q's plane: abscissa, distance from the joint.
using PlanePoint = std::pair<std::int64_t, std::int64_t>;

}  // namespace

bool draw_small_cubic(const LocalGraph& graph, Output& output) {
  const auto is_cubic = [](const NeighbourList& near) { return near.degree() == 3; };
  if (graph.size() == 4 &&
      std::all_of(graph.neighbours.begin(), graph.neighbours.end(), is_cubic)) {
    draw_table(graph, std::array<Vertex, 4>{0, 1, 2, 3}, kK4Vertices, kK4Edges, output);
    return true;
  }
  const auto sides = sides_of_k33(graph);
  if (!sides) return false;
  draw_table(graph, *sides, kK33Vertices, kK33Edges, output);
  return true;
}

void draw_q_body(const LocalGraph& graph, const QBody& body, Point at, bool upwards,
                 Output& output) {
  const auto point = [&](PlanePoint p) {
    const auto [a, h] = p;
    return upwards ? Point{at.x, at.y + a, at.z + h} : Point{at.x + a, at.y, at.z - h};
  };
  const auto join = [&](Vertex u, Vertex v,
                        std::initializer_list<PlanePoint> bends) {  // from the joint
    std::vector<Point> points;
    for (const PlanePoint& bend : bends) points.push_back(point(bend));
    if (!upwards) std::reverse(points.begin(), points.end());
    output.set_bends(edge_between(graph, u, v), points);
  };
  const auto [y, c] = body.side;
  const auto [t, w] = body.core;
  output.set_vertex(graph.name[body.joint], at);
  output.set_vertex(graph.name[y], point({-2, 6}));
  output.set_vertex(graph.name[c], point({2, 6}));
  output.set_vertex(graph.name[t], point({0, 6}));
  output.set_vertex(graph.name[w], point({0, 8}));
  join(y, body.joint, {{-3, 3}, {-3, 5}});  // u = y: the joint's own row may hold its bridge only
  join(c, body.joint, {{3, 3}, {3, 5}});
  join(y, t, {{-1, 5}});
  join(c, t, {{1, 5}});
  join(y, w, {{-2, 8}, {-1, 9}});
  join(c, w, {{2, 8}, {1, 9}});
  join(t, w, {});
}

}  // namespace ar3d::two_bend
