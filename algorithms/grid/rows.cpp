// The graph renumbered in processing order, before Step 3.9: all later stages read it forwards.
// Entries are asked for 8 and 16 places ahead of use, since the far ends of edges are cache
// misses. O(n + m).
#include "ar3d/algorithms/grid/rows.h"

namespace ar3d::grid {

UnwrittenVector<Row> rows_in_order(const Graph& graph, const ProcessingOrder& order) {
  UnwrittenVector<Place> place_of(graph.num_vertices());
  for (Place i = 0; i < order.sequence.size(); ++i) place_of[order.sequence[i]] = i;
  UnwrittenVector<Row> rows(order.sequence.size(), Row{});
  for (Place i = 0; i < rows.size(); ++i) {
    if (i + kAhead < rows.size()) {
      for (const HalfEdge& half : graph.incident(order.sequence[i + kAhead])) {
        __builtin_prefetch(&place_of[half.to]);
      }
    }
    if (i + 2 * kAhead < rows.size()) {
      __builtin_prefetch(graph.incident(order.sequence[i + 2 * kAhead]).data());
    }
    Row& row = rows[i];
    for (const HalfEdge& half : graph.incident(order.sequence[i])) {
      row.to[row.degree] = place_of[half.to];
      row.edge[row.degree++] = half.edge;
    }
  }
  return rows;
}

}  // namespace ar3d::grid
