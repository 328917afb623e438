#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "ar3d/base/long_vector.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend {

inline constexpr Vertex kNoVertex = std::numeric_limits<Vertex>::max();

/// Loops that gather from far apart prefetch entries this many steps before they use them: several
/// waits for memory then overlap.
inline constexpr std::uint32_t kAhead = 16;
/// Prefetches an entry of an array; any index is allowed. It and all that only call it are
/// always inlined: g++ 12 drops calls of functions that do nothing else.
template <class T>
[[gnu::always_inline]] inline void prefetch(const LongVector<T>& array, std::size_t i) {
  __builtin_prefetch(array.data() + i);
}

/// The neighbours of one vertex of a component: at most three, then kNoVertex.
struct NeighbourList {
  std::array<Vertex, 3> to{kNoVertex, kNoVertex, kNoVertex};
  std::size_t degree() const {
    return std::size_t{to[0] != kNoVertex} + (to[1] != kNoVertex) + (to[2] != kNoVertex);
  }
};

/// Frees an array that is needed no more, for later ones; a short one keeps its memory for the next
/// component.
template <class T>
void release(LongVector<T>& array) {
  if (array.size() * sizeof(T) >= kReusableBytes) array = LongVector<T>();
}

/// One component, its vertices renamed in preorder of a depth-first search, so that the search tree
/// is known (parent[v] < v) and neighbours tend to lie close together in memory.
struct LocalGraph {
  LongVector<Vertex> name;  ///< of the input graph
  LongVector<NeighbourList> neighbours;
  LongVector<std::array<EdgeId, 3>> edges;  ///< of the input graph, in the order of the neighbours
  LongVector<Vertex> parent;  ///< parent[0] = 0; empty once the blocks are known, if it is long

  Vertex size() const { return static_cast<Vertex>(name.size()); }
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
  void read(Vertex v, Vertex parent, LocalGraph& out);
  void copy_rows(LocalGraph& out) const;
  void prefetch_row(const LongVector<Vertex>& name, std::size_t i) const;
  std::span<const HalfEdge> incident(Vertex v) const;

  const Graph& graph_;
  const HalfEdge* cubic_half_edges_ = nullptr;  // of all vertices, if all have degree 3
  LongVector<NeighbourList> near_;  // per input vertex: half as long as the rows of the graph
  LongVector<Vertex> local_;        // per input vertex: its new name
  std::vector<bool> is_read_;       // per input vertex; small enough to stay in the cache
  /// Input vertices that were unread when a neighbour was read, and that neighbour's new name: the
  /// next one last.
  LongVector<std::pair<Vertex, Vertex>> turns_;
  Vertex first_ = 0;
  Vertex count_ = 0;  // of the vertices read
};

}  // namespace ar3d::two_bend
