#pragma once

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

struct Options {
  /// 0: the proved core alone. 1: flat numbers, with a volume like n^2 if the defects are few or
  /// local; the core where that fails. 2: that drawing squeezed.
  int effort = kDefaultEffort;
};

/// Draws a simple graph of maximum degree 3 on the face diagonals of the unit cube grid, 3 bends
/// per edge, exactly 120 degrees at every bend and between any two segments at a vertex, in O(n) x
/// O(n) x O(n).
/// @param graph  n vertices, m edges; may be disconnected, may have bridges and isolated vertices.
/// @return extents within the guarantee of row(); lengths in unit cubes. instance_bound is
/// Lemma 3.6 with the largest plane number that occurs.
/// @throws InputError if graph.max_degree() > 3 or there is no such effort.
/// Cost: O(n log n) expected time, O(n) memory, on every input (Lemma 3.7); at effort 2 that of
/// squeezed(), too. Source: Theorem 3 of the paper, which has O(n^3) per side; docs/theorem3.md has
/// the construction and its proof.
Drawing draw(const Graph& graph, const Options& options = {});

/// Unit steps of all edges: up to so many a drawing is squeezed, in seconds.
inline constexpr std::int64_t kMostSqueezed = 1000000;

/// The same drawing in a smaller box: segments keep their directions and their order on every line,
/// and get shorter or longer.
/// @param drawing  of the graph, on face diagonals, its points of even sum, polylines from the
/// smaller end on.
/// @return extents at most those of the drawing, on every axis; its counters and instance bound. The
/// drawing itself if its edges have more than kMostSqueezed unit steps.
/// Cost: O(l log l) time for l steps, a few times for each of six diagonals; O(l) memory.
Drawing squeezed(const Graph& graph, Drawing drawing);

/// The catalogue row `grid`.
Algorithm row();

}  // namespace ar3d::grid
