#pragma once

#include <optional>

#include "ar3d/algorithms/grid/planes.h"

namespace ar3d::grid {

/// Plane numbers for a graph whose labels are a proper edge colouring (every edge is a U-edge): X_0
/// + X_1 stays small at every vertex, because the numbers follow the chains of colours 0 and 1, so
/// one of the three sides of the box is short and the volume grows like n^2. Keeps (I1)-(I3).
/// @return nothing if some edge is a defect or a clash is open.
/// Cost: O(n log n) expected.
std::optional<Planes> flat_planes(const Graph& graph, const Labels& labels);

}  // namespace ar3d::grid
