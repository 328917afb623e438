#pragma once

#include "ar3d/algorithms/catalog.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d {

struct GridOptions {
  /// 0: the proved core alone. 1: flat numbers, volume like n^2 if the defects are few or local,
  /// with Kempe chains of at most kShortChain edges against defects; the core where that fails. 2:
  /// with chains as long as `kempe`.
  int effort = 2;
  /// Half width of the core's window for plane numbers, in hundredths of n.
  std::int64_t window = 55;
  /// Longest Kempe chain that may be swapped to avoid a defect; 0: none. Without effect at effort
  /// 0.
  std::int64_t kempe = 8192;

  static constexpr std::int64_t kShortChain = 64;
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
