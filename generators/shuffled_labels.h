#pragma once

#include "ar3d/base/random.h"
#include "ar3d/model/graph.h"

namespace ar3d {

/// The graph with its labels permuted, all permutations being equally likely. The edges keep their
/// order. O(n + m).
Graph shuffled_labels(const Graph& graph, RandomStream& random);

}  // namespace ar3d
