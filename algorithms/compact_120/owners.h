#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/compact_120/order.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact_120 {

/// Every edge belongs to one of its ends, its tail; a vertex owns at most one edge to the right and
/// at most one to the left.
struct Owners {
  LongVector<Vertex> tail;  ///< by edge
  /// The vertices of all components of the slot graph that have two cycles: there some vertices own
  /// two edges on one side, so the owners cannot be used. Empty after the moves (Lemma D.8).
  std::vector<Vertex> crowded;
};

/// Step D.4. A node of the slot graph is a vertex and one of its sides; an edge joins the right
/// side of its left end with the left side of its right end. In a component with a cycle every node
/// owns an edge, in a tree every node but one leaf. So a source or sink of degree 3 owns an edge.
/// O(n).
Owners choose_owners(const Graph& graph, const Order& order);

struct RankChange {
  Vertex vertex = 0;
  std::uint32_t rank = 0;
};

/// choose_owners for an order that changes: components of the slot graph that stay are not searched
/// again.
class ChangingOwners {
 public:
  /// O(n). @param graph  outlives this.
  ChangingOwners(const Graph& graph, Order order);
  /// Gives vertices new ranks, such that adjacent ones differ after all of them. O(the components
  /// of the slot graph that change), and a sort of the crowded ones.
  void change(const std::vector<RankChange>& changes);

  const Order& order() const { return order_; }
  /// choose_owners(graph, order()).
  const Owners& owners() const { return owners_; }

 private:
  /// 2 v: the right side of v; 2 v + 1: its left side.
  using Node = std::uint32_t;
  struct Component {
    Node start = 0;         ///< its first node
    std::size_t begin = 0;  ///< where its nodes begin in a list of nodes of several
    std::size_t end = 0;
  };

  template <class Visit>
  int for_edges(Node node, Visit visit) const;
  void ask_for(Node node) const;
  void ask_ahead(Vertex v) const;
  void search_component(Node start);
  void make_root(Node node);
  void set_rank(RankChange change, std::vector<Node>& touched);
  std::vector<Component> components_of(const std::vector<Node>& touched);
  void list_crowded();

  const Graph& graph_;
  Order order_;
  LongVector<EdgeId> parent_;  ///< by node: the edge to its parent
  std::vector<Node> queue_;    ///< of a search
  std::vector<Node> nodes_;    ///< of the components that are searched again
  std::vector<Node> crowded_nodes_;
  std::vector<Component> crowded_;  ///< components with two cycles, in `crowded_nodes_`
  Owners owners_;
};

}  // namespace ar3d::compact_120
