#pragma once

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::routed {

struct Options {
  /// 0: the first legal box. 1: smaller boxes until a count of searches is used up. 2: ten times as
  /// many.
  int effort = kDefaultEffort;
  int bends = 3;         ///< 3 to 5: at most so many per edge
  int megabytes = 1000;  ///< that the points of a box may take
};

/// Draws a simple graph of maximum degree 4 (body diagonals, 109.47 degrees) or 3 (face diagonals,
/// 120 degrees) with its edges routed through a small box by negotiated congestion, or as the
/// fall-back draws it where that is smaller (docs/routed.md).
/// @param graph  n <= 2^27 vertices; may be disconnected. Above 10,000 vertices the fall-back is
/// returned at once.
/// @return points on the unit cube grid, anywhere in space; extents within row_109()'s or
/// row_120()'s guarantee. Fall-back: `diamond` or `grid`; with five bends the smaller of that and
/// `compact` or `compact-120`. Counters: routed (1, or 0: the fall-back), boxes tried, legal_boxes
/// of them, searches for routes, conflicts (edges left when the last box that failed was given up),
/// bytes (of the largest box). instance_bound is that of the fall-back if the drawing keeps it.
/// @throws InputError if graph.max_degree() > 4 or 3, an option is out of range, or the first box
/// needs more than the megabytes.
/// Cost: the searches; memory: 5 bytes for each point of the class in the box, and in each thread 2
/// bytes for each bend, direction and point of the window that it searches; O(n) besides.
Drawing draw_109(const Graph& graph, const Options& options = {});
Drawing draw_120(const Graph& graph, const Options& options = {});

/// The catalogue rows `routed` and `routed-120`.
Algorithm row_109();
Algorithm row_120();

}  // namespace ar3d::routed
