#pragma once

#include <cstdint>

#include "ar3d/algorithms/algorithm.h"
#include "ar3d/algorithms/two_bend_109/stubs.h"
#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend_109 {

struct Options {
  /// 0: the scale of the size bound's proof. 1: begins with a small one.
  int effort = kDefaultEffort;
  /// Points along the side of the square that a vertex chooses from at first, with effort 1: a
  /// power of 2. Doubled for a component as long as that cannot be placed.
  std::int64_t first_jitter = 16;
};

/// Draws a simple graph of maximum degree 4 with two bends per edge and all angles at least
/// arccos(-1/3) (docs/two-bend-109.md).
/// @param graph  n vertices, m edges; may be disconnected.
/// @return points of kAxisLattice; smallest x, y and z are 0. Counters: components, singles,
/// cycles, bodies, slots, jitter (the largest one needed), tried (points, of all vertices).
/// instance_bound is the box of all that the squares of that scale allow.
/// @throws InputError if graph.max_degree() > 4, or naming a vertex whose coordinates may pass
/// 2^60. Cost: O(n) per point tried, of which there is one per vertex in practice; O(n) memory.
Drawing draw(const Graph& graph, const Options& options = {});

/// The catalogue row `two-bend-109`.
Algorithm row();

}  // namespace ar3d::two_bend_109
