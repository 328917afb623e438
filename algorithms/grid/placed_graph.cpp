// The graph renamed by places, before Steps 3.2 to 3.5. In a breadth-first order the two ends of a
// tree edge are read in two streams, so only the edges that close cycles miss the cache. O(n + m).
#include "ar3d/algorithms/grid/placed_graph.h"

namespace ar3d::grid {

PlacedGraph::PlacedGraph(std::span<const NeighbourPlaces> neighbours)
    : rows_(neighbours.size(), Row{}) {
  edge_of_.reserve(neighbours.size() * 3 / 2);
  for (Place v = 0; v < neighbours.size(); ++v) {
    if (v + kAhead < neighbours.size()) {
      for (const Place to : neighbours[v + kAhead].to) __builtin_prefetch(&rows_[to]);
    }
    const NeighbourPlaces& own = neighbours[v];
    Row& row = rows_[v];
    for (unsigned i = 0; i < own.degree; ++i) {
      row.half[i].to = own.to[i];
      if (own.to[i] > v) {
        row.half[i].edge = num_edges();
        edge_of_.push_back(own.edge[i]);
        continue;
      }
      const HalfEdge* back = rows_[own.to[i]].half.data();
      while (back->to != v) ++back;
      row.half[i].edge = back->edge;
    }
    row.degree = own.degree;
  }
}

}  // namespace ar3d::grid
