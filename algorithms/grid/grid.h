#pragma once

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

struct Options {
  /// 0: the proved core alone. 1: flat numbers, with a volume like n^2 if the defects are few or
  /// local; the core where that fails. There is no 2: longer searches gain nothing.
  int effort = kDefaultEffort;
};

/// Draws a simple graph of maximum degree 3 on the face diagonals of the unit cube grid, 3 bends
/// per edge, exactly 120 degrees at every bend and between any two segments at a vertex, in O(n) x
/// O(n) x O(n).
/// @param graph  n vertices, m edges; may be disconnected, may have bridges and isolated vertices.
/// @return extents within the guarantee of row(); lengths in unit cubes. instance_bound is
/// Lemma 3.6 with the largest plane number that occurs.
/// @throws InputError if graph.max_degree() > 3 or there is no such effort.
/// Cost: O(n log n) expected time, O(n) memory, on every input (Lemma 3.7). Source: Theorem 3 of
/// the paper, which has O(n^3) per side; docs/theorem3.md has the construction and its proof.
Drawing draw(const Graph& graph, const Options& options = {});

/// The catalogue row `grid`.
Algorithm row();

}  // namespace ar3d::grid
