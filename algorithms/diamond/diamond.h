#pragma once

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::diamond {

struct Options {
  /// 0: the construction whose box the theorem's proof bounds. 1: alternating parity, or 0 if that
  /// passes the theorem's box; up to kMostCompared vertices the smaller of both. 2: the smallest of
  /// these, of pairs, of jointly rotated cycles and of annealed parity, so never larger than 0 and 1.
  int effort = kDefaultEffort;
};

/// Draws a simple graph of maximum degree 4 on the diamond lattice (Theorem 1).
/// @param graph  n <= 2^27 vertices, m edges; may be disconnected.
/// @return n points with z = 0 and 3 bends per edge, on the unit cube grid; segments parallel to
/// (±1, ±1, ±1); extents at most 16n/3, 16n/3, 8n. Counters: mode (0 guaranteed, 1 alternating, 2
/// pairs, 3 jointly rotated, 4 annealed), m_green, m_red, hits in parity modes, and in the
/// guaranteed mode the terms of H (GapCount). instance_bound is the guaranteed mode's 4n + 2H,
/// 4n + 2H, 6n + 3H - 4; effort 2 keeps it with H where its drawing fits it.
/// @throws InputError if graph.max_degree() > 4, n > 2^27 or there is no such effort.
/// Cost: O(n + m) time and memory; effort 2 takes 6 to 17 times as long as effort 1 (measured,
/// results/reference/theorem1.md). Differs from the paper: the box is that of the input without
/// dummy vertices, height 8n instead of 16n; docs/theorem1.md.
Drawing draw(const Graph& graph, const Options& options = {});

/// The catalogue row `diamond`.
Algorithm row();

}  // namespace ar3d::diamond
