#pragma once

#include <optional>

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/algorithms/compact/fill.h"
#include "ar3d/algorithms/compact/letters.h"
#include "ar3d/algorithms/compact/strip.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact {

struct Options {
  /// 0: the zones of the size bound's proof. 1: a narrow strip. 2: a narrower one, slower.
  int effort = kDefaultEffort;
};

/// Draws a simple graph of maximum degree 4 on the diamond lattice with five bends per edge in
/// volume O(n^1.5) (docs/compact.md).
/// @param graph  n <= 2^27 vertices, m edges; may be disconnected.
/// @return n points with z = 0 and 5 bends per edge, on the unit cube grid; segments parallel to
/// (±1, ±1, ±1);
///   extents at most 726 sqrt(n) + 1800, the same, 724 sqrt(n) + 1800. Counters: zones (1 if the
///   proof's zones were needed), widenings, ejections, trials, scans, columns, rows, reach.
///   instance_bound is the box of the strip that was filled.
/// @throws InputError if graph.max_degree() > 4, n > 2^27 or there is no such effort.
/// Cost: O(n + m) cells tried with O(1) look-ups each, in expectation over the fixed random stream;
/// O(n + m) memory.
Drawing draw(const Graph& graph, const Options& options = {});

/// As draw, beginning with a narrow strip of the given tightness; without one, in the zones.
Drawing draw_from(const Graph& graph, const std::optional<Tightness>& first);

/// The catalogue row `compact`.
Algorithm row();

/// Bounds on the extents of any drawing in a strip of this size.
std::array<std::int64_t, 3> box_of(const StripSize& size);

/// The drawing in space; one byte per edge besides the graph's own edge list.
Drawing lift(const Graph& graph, const Decomposition& links, const Placement& placement);

}  // namespace ar3d::compact
