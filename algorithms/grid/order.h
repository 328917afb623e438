#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "ar3d/base/long_vector.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

/// A vertex's index in the processing order (ProcessingOrder::sequence).
using Index = std::uint32_t;
inline constexpr Index kAhead = 8;  ///< indices between prefetch and use
inline constexpr Index kNoIndex = std::numeric_limits<Index>::max();

/// One component's indices [begin, end) in the processing order.
struct OrderPart {
  Index begin = 0;
  Index end = 0;
  bool cubic = false;  ///< every degree is 3; then sequence[begin] = f and sequence[end - 1] = r
  std::int64_t size() const { return std::int64_t{end} - begin; }
};

/// The order in which vertices get their labels and positions.
/// Invariant: in a component with a vertex of degree <= 2, every vertex but the last has a later
/// neighbour, and the last one has degree <= 2. In a cubic component f comes first, r is a
/// neighbour of f and comes last, and every vertex but f and r has a later neighbour. (So every
/// vertex but r has at most two earlier ones.)
struct ProcessingOrder {
  std::vector<Vertex> sequence;
  std::vector<OrderPart> parts;
};

/// Step 3.1: reverse breadth-first orders. Cost: O(n + m).
ProcessingOrder processing_order(const Graph& graph);

/// The half-edges at one vertex, in the order of the graph's row; neighbours are indices.
struct alignas(32) PlacedRow {
  std::array<HalfEdge, 3> half{};
  std::uint32_t degree = 0;
  std::span<const HalfEdge> halves() const { return {half.data(), degree}; }
};

/// The graph renumbered in processing order, so that later stages read memory forwards and
/// "earlier" is a comparison of indices. Cost: O(n + m).
UnwrittenVector<PlacedRow> neighbours_in_order(const Graph& graph, const ProcessingOrder& order);

/// The graph with every vertex renamed to its index and the edges numbered by their earlier indices:
/// what is near in the order is near in memory. Rows keep the order of the graph's.
class PlacedGraph {
 public:
  /// Cost: O(n + m).
  explicit PlacedGraph(UnwrittenVector<PlacedRow> neighbours);

  Index num_vertices() const { return static_cast<Index>(rows_.size()); }
  EdgeId num_edges() const { return static_cast<EdgeId>(edge_of_.size()); }
  std::span<const HalfEdge> incident(Index v) const { return rows_[v].halves(); }
  /// The graph's number of edge e.
  EdgeId edge_of(EdgeId e) const { return edge_of_[e]; }

 private:
  UnwrittenVector<PlacedRow> rows_;
  UnwrittenVector<EdgeId> edge_of_;
};

}  // namespace ar3d::grid
