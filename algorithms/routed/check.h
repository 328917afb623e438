#pragma once

#include "ar3d/algorithms/routed/negotiation.h"

namespace ar3d::routed {

/// Returns whether a routing is a drawing: every route leads from its edge's one end to the other
/// along the class within the limits, with at most so many bends, turns that the angles allow,
/// arms of one frame at each vertex, no arm twice, and no point twice. Then no edges meet but in
/// their ends (Lemma R.2). O(n + length of all routes) time and memory, from the routing alone.
bool is_drawing(const Graph& graph, const PointClass& points, int bends, const Routing& routing);

}  // namespace ar3d::routed
