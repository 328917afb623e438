#pragma once

#include "ar3d/algorithms/catalog.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d {

struct DiamondOptions {
  /// 0: alternating parity; 1: the smallest of alternating parity, 0011 parity and the guaranteed
  /// mode; 2: also with joint rotation and with annealed parity. The volume never grows with the
  /// effort.
  int effort = 0;
  /// The guaranteed mode alone, whatever the effort: the construction whose box the theorem's proof
  /// bounds.
  bool guaranteed = false;
};

/// Draws a simple graph of maximum degree 4 on the diamond lattice (Theorem 1).
/// @param graph  n <= 2^27 vertices, m edges; may be disconnected.
/// @return n points with z = 0 and 3 bends an edge, on the unit cube grid; segments parallel to
/// (±1, ±1, ±1); extents at most
///   16n/3, 16n/3, 8n. Counters: mode (0 guaranteed, 1 alternating, 2 pairs, 3 jointly rotated, 4
///   annealed), m_green, m_red, hits in compact modes, and in the guaranteed mode the terms of H
///   (GapCount). instance_bound is the guaranteed mode's 4n + 2H, 4n + 2H, 6n + 3H - 4; efforts 1
///   and 2 keep it with H where their drawing fits it.
/// @throws InputError if graph.max_degree() > 4 or n > 2^27.
/// Cost: O(n + m) time and memory, about 5 times as much time at effort 1 and 20 times at effort 2.
/// Differs from the paper: the box is that of the input without dummy vertices, height 8n instead
/// of 16n; docs/theorem1.md.
Drawing diamond(const Graph& graph, const DiamondOptions& options = {});

/// The catalogue's row.
Algorithm diamond_row();

}  // namespace ar3d
