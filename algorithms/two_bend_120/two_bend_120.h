#pragma once

#include "ar3d/algorithms/algorithm.h"

namespace ar3d::two_bend_120 {

/// Draws graphs whose components are cubic and 3-connected with at most two bends per edge, and
/// those that two edges cut where the steps succeed: all segments are parallel to face diagonals of
/// the cube grid, all angles exactly 120 degrees.
/// Proof: docs/two-bend-120.md; box: O(n^2) x O(n^2) x O(n), see row(). Counters: components,
/// core (the vertices left when triangles are contracted), small_cores (components drawn from the
/// table).
/// @throws InputError naming a vertex of another degree, a bridge, or a vertex of a component that
/// is not 3-connected and for which none is found. Cost: O(n log n) expected and one thread, for
/// every numbering that is tried (one if 3-connected), and O(n) for every pair of ends that Step F.3
/// tries beyond the first; O(n) memory.
Drawing draw(const Graph& graph);

/// The catalogue row `two-bend-120`.
Algorithm row();

}  // namespace ar3d::two_bend_120
