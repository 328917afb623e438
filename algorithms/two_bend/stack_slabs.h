#pragma once

#include <vector>

#include "ar3d/algorithms/two_bend/blocks.h"
#include "ar3d/algorithms/two_bend/output.h"
#include "ar3d/algorithms/two_bend/slab.h"

namespace ar3d::two_bend {

/// Everything found out about one component, ready to be drawn.
struct Component {
  const LocalGraph& graph;
  const TimeOrder& order;
  const Flow& flow;
  const Layout& layout;
  const Slabs& slabs;
  const LongVector<QBody>& bodies;
};

/// Step 2.11: gives every vertex its own slab in time order (z), x and y from rays and poles, and
/// writes vertices and bends, translated so that the smallest x and y of the component are 0. Cost:
/// O(n).
void stack_slabs(const Component& component, Output& output);

}  // namespace ar3d::two_bend
