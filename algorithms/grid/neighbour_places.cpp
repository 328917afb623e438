// The graph renumbered in processing order, before Step 3.9: all later stages read it forwards.
// Entries are asked for 8 and 16 places ahead of use, since the far ends of edges are cache
// misses. O(n + m).
#include "ar3d/algorithms/grid/neighbour_places.h"

namespace ar3d::grid {

UnwrittenVector<NeighbourPlaces> neighbours_in_order(const Graph& graph,
                                                     const ProcessingOrder& order) {
  UnwrittenVector<Place> place_of(graph.num_vertices());
  for (Place i = 0; i < order.sequence.size(); ++i) place_of[order.sequence[i]] = i;
  UnwrittenVector<NeighbourPlaces> neighbours(order.sequence.size(), NeighbourPlaces{});
  for (Place i = 0; i < neighbours.size(); ++i) {
    if (i + kAhead < neighbours.size()) {
      for (const HalfEdge& half : graph.incident(order.sequence[i + kAhead])) {
        __builtin_prefetch(&place_of[half.to]);
      }
    }
    if (i + 2 * kAhead < neighbours.size()) {
      __builtin_prefetch(graph.incident(order.sequence[i + 2 * kAhead]).data());
    }
    NeighbourPlaces& own = neighbours[i];
    for (const HalfEdge& half : graph.incident(order.sequence[i])) {
      own.to[own.degree] = place_of[half.to];
      own.edge[own.degree++] = half.edge;
    }
  }
  return neighbours;
}

}  // namespace ar3d::grid
