// Step P.9, the radius of each contracted vertex before anything is expanded: a third of the least
// of 1, the lengths of its own first pieces and its distance from every other segment of the
// component, rounded down to a power of two so that scaling by it is exact in every type. Measured
// on the drawing in double, segment by segment. Cost: O(m) for each contracted vertex.
#include "ar3d/algorithms/two_bend_paper/expansion.h"

namespace ar3d::two_bend_paper {
namespace {

using Point3 = Vector3<double>;

double distance_to_segment(const Point3& p, const Point3& a, const Point3& b) {
  const Point3 d = b - a;
  const double square = dot(d, d);
  const double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  const Point3 apart = p - (a + t * d);
  return std::sqrt(dot(apart, apart));
}

/// The least of 1, the lengths of the node's own first pieces and its distance from every other
/// segment of its component.
double clearance_of(Node node, const std::vector<EdgeId>& edges, const ContractedGraph& graph,
                    const NodePoints<double>& points) {
  double least = 1;
  for (const EdgeId edge : edges) {
    const auto [from, to] = graph.ends[edge];
    Point3 a = points.of_node[from];
    const auto& bends = points.bends[edge];
    for (std::size_t i = 0; i <= bends.size(); ++i) {
      const Point3 b = i < bends.size() ? bends[i] : points.of_node[to];
      const bool is_first = (i == 0 && from == node) || (i == bends.size() && to == node);
      const Point3 d = b - a;
      least = std::min(
          least, is_first ? std::sqrt(dot(d, d)) : distance_to_segment(points.of_node[node], a, b));
      a = b;
    }
  }
  return least;
}

/// The nodes of a component, and whether the two edges of each leave it at 180 degrees.
std::vector<std::pair<Node, bool>> nodes_of(const ContractedGraph& graph,
                                            const Component& component) {
  std::vector<std::pair<Node, bool>> nodes;
  if (component.k4) {
    for (const Node node : *component.k4) nodes.emplace_back(node, false);
  }
  for (const Step& step : component.steps) {
    const bool is_pass = step.kind == StepKind::pass && graph.stars[step.node].size() == 2;
    if (step.kind != StepKind::cycle) nodes.emplace_back(step.node, is_pass);
    for (const CycleVertex& vertex : step.cycle) nodes.emplace_back(vertex.node, false);
  }
  return nodes;
}

}  // namespace

std::vector<std::pair<double, bool>> top_rooms(const ContractedGraph& graph,
                                               const std::vector<Component>& components,
                                               std::size_t num_edges) {
  std::vector<std::pair<double, bool>> rooms(graph.contractions.size());
  if (rooms.empty()) return rooms;
  const NodePoints<double> points = stack<double>(graph, components, num_edges);
  const auto inputs = graph.num_nodes() - static_cast<Node>(rooms.size());
  for (const Component& component : components) {
    const std::vector<std::pair<Node, bool>> nodes = nodes_of(graph, component);
    std::vector<EdgeId> edges;
    for (const auto& [node, is_straight] : nodes) {
      for (const HalfEdge incidence : graph.stars[node]) {
        if (graph.ends[incidence.edge][0] == node) edges.push_back(incidence.edge);
      }
    }
    for (const auto& [node, is_straight] : nodes) {
      if (node < inputs) continue;
      const double third = clearance_of(node, edges, graph, points) / 3;
      rooms[node - inputs] = {std::exp2(std::floor(std::log2(third))), is_straight};
    }
  }
  return rooms;
}

}  // namespace ar3d::two_bend_paper
