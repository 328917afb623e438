#pragma once

#include <string>

#include "ar3d/algorithms/grid/planes.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

/// Tests (I1)-(I5) of docs/theorem3.md, from which the proof concludes that the drawing has no
/// crossing.
/// @return "" or the first broken rule with the edge or vertex that breaks it. Cost: O(n log n).
std::string broken_invariant(const Graph& graph, const Planes& planes);

}  // namespace ar3d::grid
