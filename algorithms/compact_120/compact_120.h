#pragma once

#include <optional>

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/algorithms/compact_120/fill.h"
#include "ar3d/algorithms/compact_120/strip.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact_120 {

struct Options {
  /// 0: the zones of the size bound's proof. 1: a narrow strip. 2: a narrower one, slower.
  int effort = kDefaultEffort;
};

/// Draws a simple graph of maximum degree 3 along face diagonals with all angles 120 degrees and
/// five bends per edge in volume O(n^1.5) (docs/compact-120.md).
/// @param graph  n <= 2^27 vertices, m edges; may be disconnected.
/// @return n points of the plane 5x + 5y = 3z and 5 bends per edge, on the unit cube grid; extents
/// at
///   most 580 sqrt(n) + 13000, the same, 725 sqrt(n) + 16200. Counters: zones (1 if the proof's
///   zones were needed), widenings, ejections, trials, scans, columns, rows, beyond,
///   moved_components. instance_bound is the box of the strip that was filled.
/// @throws InputError if graph.max_degree() > 3, n > 2^27 or there is no such effort.
/// Cost: O(n + m) cells tried with O(1) look-ups each, in expectation over the fixed random stream;
/// O(n + m) memory.
Drawing draw(const Graph& graph, const Options& options = {});

/// As draw, beginning with a narrow strip of the given tightness; without one, in the zones.
Drawing draw_from(const Graph& graph, const std::optional<Tightness>& first);

/// The catalogue row `compact-120`.
Algorithm row();

/// Bounds on the extents of any drawing in a strip of this size (Lemma D.10).
std::array<std::int64_t, 3> box_of(const StripSize& size);

/// The drawing in space; one byte per edge besides the graph's own edge list.
Drawing lift(const Graph& graph, const Strip& strip);

}  // namespace ar3d::compact_120
