#pragma once

#include <vector>

#include "ar3d/algorithms/compact_120/order.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact_120 {

/// Every edge belongs to one of its ends, its tail; a vertex owns at most one edge to the right and
/// at most one to the left.
struct Owners {
  std::vector<Vertex> tail;  ///< by edge
  /// The vertices of all components of the slot graph that have two cycles: there some vertices own
  /// two edges on one side, so the owners cannot be used. Empty after the moves (Lemma D.8).
  std::vector<Vertex> crowded;
};

/// Step D.4. A node of the slot graph is a vertex and one of its sides; an edge joins the right
/// side of its left end with the left side of its right end. In a component with a cycle every node
/// owns an edge, in a tree every node but one leaf. So a source or sink of degree 3 owns an edge.
/// O(n).
Owners choose_owners(const Graph& graph, const Order& order);

}  // namespace ar3d::compact_120
