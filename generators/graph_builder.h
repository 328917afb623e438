#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d {

/// Numbers of vertices, copies, rings, ... in the arithmetic of the generators. Every family keeps
/// n below 2^31, so that no product of this folder comes near 2^64.
using Count = std::uint64_t;

/// Collects the edges of a graph under construction. Whether the graph is simple is for Graph to
/// check.
class GraphBuilder {
 public:
  /// @param num_vertices  n; more vertices can be added later.
  /// @param expected_edges  room to reserve.
  explicit GraphBuilder(Count num_vertices, Count expected_edges = 0);

  Count num_vertices() const { return num_vertices_; }
  /// Adds `count` vertices and returns the number of the first.
  Count add_vertices(Count count);
  void edge(Count u, Count v);
  /// Adds the edges of a list, with `first` added to both ends.
  void edges(std::span<const Edge> list, Count first = 0) {
    for (const Edge e : list) edge(first + e.u, first + e.v);
  }
  /// The path first, first + 1, ..., first + count - 1.
  void path(Count first, Count count);
  /// The cycle on the same vertices; count >= 3.
  void cycle(Count first, Count count);
  /// A disjoint copy of `part` on new vertices; returns the first of them.
  Count append(const Graph& part);

  /// The graph; the builder is empty afterwards.
  Graph finish();

 private:
  Count num_vertices_;
  std::vector<Edge> edges_;
};

}  // namespace ar3d
