#pragma once

#include <array>
#include <span>

#include "ar3d/algorithms/grid/neighbour_places.h"

namespace ar3d::grid {

/// The graph with every vertex renamed to its place and the edges numbered by their earlier places:
/// what is near in the order is near in memory. Rows keep the order of the graph's.
class PlacedGraph {
 public:
  /// Cost: O(n + m).
  explicit PlacedGraph(std::span<const NeighbourPlaces> neighbours);

  Place num_vertices() const { return static_cast<Place>(rows_.size()); }
  EdgeId num_edges() const { return static_cast<EdgeId>(edge_of_.size()); }
  std::span<const HalfEdge> incident(Place v) const {
    return {rows_[v].half.data(), rows_[v].degree};
  }
  /// The graph's number of edge e.
  EdgeId edge_of(EdgeId e) const { return edge_of_[e]; }

 private:
  struct alignas(32) Row {
    std::array<HalfEdge, 3> half;
    std::uint32_t degree = 0;
  };
  UnwrittenVector<Row> rows_;
  UnwrittenVector<EdgeId> edge_of_;
};

}  // namespace ar3d::grid
