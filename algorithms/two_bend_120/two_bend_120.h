#pragma once

#include "ar3d/algorithms/algorithm.h"

namespace ar3d::two_bend_120 {

/// Draws graphs whose components are cubic and 3-connected with at most two bends per edge: all
/// segments are parallel to face diagonals of the cube grid, all angles exactly 120 degrees.
/// Proof: docs/two-bend-120.md; box: O(n^2) x O(n^2) x O(n), see row(). Counters: components,
/// core (the vertices left when triangles are contracted), small_cores (components drawn from the
/// table).
/// @throws InputError naming a vertex of another degree, a bridge, or two edges that cut a
/// component. Cost: O(n log n) expected and one thread, and O(n) for every pair of ends that Step
/// F.3 tries beyond the first; O(n) memory.
Drawing draw(const Graph& graph);

/// The catalogue row `two-bend-120`.
Algorithm row();

}  // namespace ar3d::two_bend_120
