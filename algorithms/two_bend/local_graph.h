#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d::two_bend {

/// The half-edges of one vertex of a component, with room for three.
struct Row {
  std::array<Vertex, 3> to{};
  std::array<EdgeId, 3> edge{};  ///< numbers of the input graph
  std::uint8_t degree = 0;
};

/// One component, its vertices renamed in preorder of a depth-first search, so that the search tree
/// is known (parent[v] < v) and neighbours tend to lie close together in memory.
struct LocalGraph {
  std::vector<Vertex> name;  ///< of the input graph
  std::vector<Row> rows;
  std::vector<Vertex> parent;  ///< parent[0] = 0

  Vertex size() const { return static_cast<Vertex>(rows.size()); }
  bool adjacent(Vertex u, Vertex v) const;
};

/// Cuts a graph of maximum degree 3 into its components. Cost of all calls together: O(n + m) time.
class ComponentReader {
 public:
  explicit ComponentReader(const Graph& graph);
  /// Fills `out` with the component of the smallest input vertex not yet read; false when none is
  /// left.
  bool next(LocalGraph& out);

 private:
  void search_from(Vertex root, LocalGraph& out);
  void visit(Vertex v, Vertex parent, LocalGraph& out);

  const Graph& graph_;
  std::vector<Vertex> local_;        // kUnread until named
  std::vector<std::uint8_t> slots_;  // of the component being read: half-edges looked at
  Vertex first_ = 0;
};

}  // namespace ar3d::two_bend
