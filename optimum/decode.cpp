// A model as a drawing: positions are read off, and edges are followed step by step.
#include "ar3d/base/error.h"
#include "ar3d/optimum/encoding.h"

namespace ar3d::optimum {

Drawing Encoding::decode(const Model& model) const {
  const auto is_true = [&](int variable) { return model[static_cast<std::size_t>(variable)]; };
  std::vector<int> position(graph_.num_vertices(), -1);
  for (Vertex u = 0; u < graph_.num_vertices(); ++u) {
    for (int p = 0; p < num_points(); ++p) {
      if (is_true(vertex_at_[u][static_cast<std::size_t>(p)])) position[u] = p;
    }
    expect(position[u] >= 0, "a model places every vertex");
  }
  const int plane =
      question_.in_plane ? points_.points[static_cast<std::size_t>(position[0])][2] : 0;
  const auto in_space = [&](Point p) { return p + Vector{0, 0, -plane}; };
  std::vector<Point> vertices;
  for (Vertex u = 0; u < graph_.num_vertices(); ++u) {
    const auto& [x, y, z] = points_.points[static_cast<std::size_t>(position[u])];
    vertices.push_back(in_space({x, y, z}));
  }
  std::vector<std::vector<Point>> bends;
  for (EdgeId e = 0; e < graph_.num_edges(); ++e) {
    bends.push_back(bends_of(e, position, model));
    for (Point& p : bends.back()) p = in_space(p);
  }
  return drawing_from_points("optimum", graph_, vertices, bends);
}

std::vector<Point> Encoding::bends_of(EdgeId e, const std::vector<int>& position,
                                      const Model& model) const {
  const auto is_true = [&](int variable) {
    return variable != 0 && model[static_cast<std::size_t>(variable)];
  };
  const auto first_true = [&](const Row& of) {
    for (std::size_t d = 0; d < of.size(); ++d) {
      if (is_true(of[d])) return d;
    }
    throw InternalError("a model leads every edge on");
  };
  std::vector<Point> bends;
  std::size_t d = first_true(leaves_[e][0]);
  int p = position[graph_.edge(e).u];
  for (int steps = 0; steps < num_points(); ++steps) {
    p = points_.neighbours[static_cast<std::size_t>(p)][d];
    expect(p >= 0, "a model keeps every edge in its box");
    if (p == position[graph_.edge(e).v]) return bends;
    const std::size_t next = first_true(step_[static_cast<std::size_t>(p)]);
    const auto& [x, y, z] = points_.points[static_cast<std::size_t>(p)];
    if (next != d) bends.push_back({x, y, z});
    d = next;
  }
  throw InternalError("a model ends every edge");
}

}  // namespace ar3d::optimum
