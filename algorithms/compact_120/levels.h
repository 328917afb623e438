#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/compact_120/arms.h"
#include "ar3d/algorithms/compact_120/order.h"
#include "ar3d/algorithms/strips/numbers_ahead.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact_120 {

/// Where in a narrow strip a vertex belongs: 0 at the left end to 100 at the right end; larger for
/// the right end of an edge than for the left one.
using Position = std::uint8_t;

/// An order for narrow strips, what follows from it, and where vertices belong.
struct NarrowOrder {
  Links links;
  std::vector<Position> position;     ///< by vertex
  std::int64_t moved_components = 0;  ///< components of the graph that needed moved_order
};

/// Step D.6: a random proper colouring with four levels, then sweeps in which every vertex goes to
/// the level with which the fewest sources and sinks of degree 3 are near it, until no component of
/// the slot graph has two cycles. Components of the graph where a bounded number of sweeps does not
/// achieve that get the order of Steps D.1 to D.3. O(n), then O(n log n).
/// @param repairs  how often components with two cycles get a new start before they are given up.
NarrowOrder narrow_order(const Graph& graph, const strips::NumbersAhead& random, int repairs = 30);

}  // namespace ar3d::compact_120
