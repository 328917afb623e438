// What is asked of a drawing, and of which graphs it can be asked.
#include "ar3d/optimum/question.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"

namespace ar3d::optimum {

std::string to_string(const BoxSize& box) {
  return fmt::format("{} x {} x {}", box[0], box[1], box[2]);
}

std::vector<Vector> steps_of(Diagonals diagonals) {
  std::vector<Vector> steps;
  const std::int64_t squared = diagonals == Diagonals::body ? 3 : 2;
  for (std::int64_t x = -1; x <= 1; ++x) {
    for (std::int64_t y = -1; y <= 1; ++y) {
      for (std::int64_t z = -1; z <= 1; ++z) {
        if (x * x + y * y + z * z == squared) steps.push_back({x, y, z});
      }
    }
  }
  return steps;
}

Guarantee guarantee_of(const Question& question) {
  const bool is_body = question.diagonals == Diagonals::body;
  Guarantee guarantee;
  guarantee.max_degree = is_body ? 4 : 3;
  guarantee.max_bends = question.max_bends;
  guarantee.angle_rule = AngleRule::exactly;
  guarantee.cosine = is_body ? Cosine{-1, 3} : Cosine{-1, 2};
  guarantee.lattice = kCubeLattice;
  for (const Vector& step : steps_of(question.diagonals)) {
    if (step > -step) guarantee.directions.push_back(step);
  }
  guarantee.vertices_in_plane = question.in_plane;
  return guarantee;
}

void refuse_unanswerable(const Graph& graph, const Question& question) {
  const Guarantee guarantee = guarantee_of(question);
  if (question.max_bends > kMostBends) {
    throw InputError(fmt::format("{} bends: {} are the most", question.max_bends, kMostBends));
  }
  if (graph.num_vertices() == 0) throw InputError("a graph without vertices has no box");
  if (graph.num_vertices() > kMostVertices) {
    throw InputError(fmt::format("{} vertices: graphs of at most {} can be asked about",
                                 graph.num_vertices(), kMostVertices));
  }
  if (graph.max_degree() > guarantee.max_degree) {
    throw InputError(fmt::format("degree {}: at this angle {} edges meet at the most",
                                 graph.max_degree(), guarantee.max_degree));
  }
  if (const auto components = connected_components_of(graph); components.count > 1) {
    throw InputError(
        fmt::format("{} components: only connected graphs can be asked about", components.count));
  }
}

}  // namespace ar3d::optimum
