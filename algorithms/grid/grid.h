#pragma once

#include "ar3d/algorithms/catalog.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d {

struct GridOptions {
  /// 0: the proved core alone. 1: Kempe chains against defects, numbers that keep the box small,
  /// the core as fallback. 2: and a flat box, volume O(n^2), when the chains left no defect.
  int effort = 2;
  /// Half width of the window for plane numbers and their pairwise sums, in hundredths of n.
  std::int64_t window = 55;
  /// Longest Kempe chain that may be swapped to avoid a defect; 0: none. Without effect at effort
  /// 0.
  std::int64_t kempe = 1000000;
};

/// Draws a simple graph of maximum degree 3 on the face diagonals of the unit cube grid, 3 bends an
/// edge, exactly 120 degrees at every bend and between any two segments at a vertex, in O(n) x O(n)
/// x O(n).
/// @param graph  n vertices, m edges; may be disconnected, may have bridges and isolated vertices.
/// @return extents within the guarantee of grid_row(); lengths in unit cubes.
/// @throws InputError if graph.max_degree() > 3.
/// Cost: O(n log n) expected time, O(n) memory, on every input. Source: Theorem 3 of the paper,
/// which has O(n^3) a side; docs/theorem3.md has the construction and its proof.
Drawing draw_grid(const Graph& graph, const GridOptions& options = {});

/// The catalogue's row.
Algorithm grid_row();

}  // namespace ar3d
