#pragma once

#include "ar3d/algorithms/grid/order.h"
#include "ar3d/algorithms/grid/planes.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

/// Step 3.7: moves the components' drawings apart, side by side in layers of about square shape,
/// the thickest first. A move by multiples of 6 along the axes adds integers to the plane numbers
/// of a component and keeps its routes. Cost: O(n + m + k log k) for k > 1 components, O(1) for
/// one.
void pack_components(const Graph& graph, const ProcessingOrder& order, Planes& planes);

}  // namespace ar3d::grid
