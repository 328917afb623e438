#pragma once

#include <vector>

#include "ar3d/algorithms/two_bend/blocks.h"

namespace ar3d::two_bend {

/// The order in which a component is swept upwards. Invariant: exactly one vertex has no earlier
/// neighbour; a vertex of degree 3 without a later neighbour has two neighbours with exactly two
/// earlier and one later neighbour, and the first vertex, if it has degree 3, has two neighbours
/// with one earlier and two later neighbours.
struct TimeOrder {
  LongVector<Vertex> list;
  bool joint =
      false;  ///< cubic and bridgeless: both ends of the list are such vertices, in one block
};

/// Steps 2.2 to 2.5: the root, the walk over the block tree, repairs of true
/// sinks. Q bodies on bridges are cut off already; the component is not K4, K3,3 or a lone Q block.
/// Cost: O(n).
TimeOrder find_time_order(const LocalGraph& graph, const Blocks& blocks);

}  // namespace ar3d::two_bend
