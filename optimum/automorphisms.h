#pragma once

#include <utility>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d::optimum {

/// Returns the pairs (i, j), i < j, such that an automorphism of the graph fixes 0, ..., i - 1 and
/// maps i to j. Exponential in the worst case; the graph is connected and small.
std::vector<std::pair<Vertex, Vertex>> orbit_pairs(const Graph& graph);

}  // namespace ar3d::optimum
