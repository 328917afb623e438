// Step D.4: owners. A search from any node of a component directs every edge it uses to its parent:
// each node but the root owns the edge to its parent. The root is then moved to a leaf or, if there
// is a cycle, to an end of the edge that the search did not use, which the root owns. Cost: O(n).
#include "ar3d/algorithms/compact_120/owners.h"

#include <cstdint>

namespace ar3d::compact_120 {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// 2 v: the right side of v; 2 v + 1: its left side.
using Node = std::uint32_t;
Vertex vertex_of(Node node) { return node / 2; }

class Search {
 public:
  Search(const Graph& graph, const Order& order)
      : graph_(graph), order_(order), parent_(2 * std::size_t{graph.num_vertices()}, kNone) {
    owners_.tail.assign(graph.num_edges(), 0);
  }

  Owners run() {
    for (Node node = 0; node < parent_.size(); ++node) {
      if (parent_[node] == kNone) search_component(node);
    }
    return std::move(owners_);
  }

 private:
  static constexpr std::uint32_t kRoot = kNone - 1;

  /// Calls visit(edge, other node) for the edges at a node; returns their number.
  template <class Visit>
  int for_edges(Node node, Visit visit) const {
    const Vertex v = vertex_of(node);
    const bool right = node % 2 == 0;
    int degree = 0;
    for (const HalfEdge& edge : graph_.incident(v)) {
      if (order_.is_right(v, edge.to) != right) continue;
      visit(edge.edge, 2 * edge.to + (right ? 1u : 0u));
      ++degree;
    }
    return degree;
  }

  void search_component(Node start) {
    queue_.assign(1, start);
    parent_[start] = kRoot;
    Node leaf = start;
    EdgeId unused = kNone;  // an edge that closes a cycle
    bool crowded = false;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Node node = queue_[i];
      const int degree = for_edges(node, [&](EdgeId edge, Node other) {
        if (edge == parent_[node] || edge == unused) return;
        if (parent_[other] == kNone) {
          parent_[other] = edge;
          owners_.tail[edge] = vertex_of(other);
          queue_.push_back(other);
        } else if (parent_[other] != edge) {
          crowded = crowded || unused != kNone;
          unused = edge;
        }
      });
      if (degree == 1) leaf = node;
    }
    if (crowded) {
      for (const Node node : queue_) owners_.crowded.push_back(vertex_of(node));
    }
    if (unused == kNone) {
      make_root(leaf);
    } else {
      const Vertex u = graph_.edge(unused).u;
      make_root(2 * u + (order_.is_right(u, graph_.edge(unused).v) ? 0u : 1u));
      owners_.tail[unused] = u;
    }
  }

  /// Every node on the way up from `node` gives its edge to its parent.
  void make_root(Node node) {
    while (parent_[node] != kRoot) {
      const EdgeId edge = parent_[node];
      const Vertex above = graph_.other_end(edge, vertex_of(node));
      owners_.tail[edge] = above;
      node = 2 * above + (node % 2 == 0 ? 1u : 0u);
    }
  }

  const Graph& graph_;
  const Order& order_;
  std::vector<EdgeId> parent_;  ///< by node: the edge to its parent
  std::vector<Node> queue_;
  Owners owners_;
};

}  // namespace

Owners choose_owners(const Graph& graph, const Order& order) { return Search(graph, order).run(); }

}  // namespace ar3d::compact_120
