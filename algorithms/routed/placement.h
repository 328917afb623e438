#pragma once

#include "ar3d/algorithms/routed/steps.h"
#include "ar3d/base/random.h"
#include "ar3d/model/graph.h"

namespace ar3d::routed {

/// A rough place for each vertex: a cell of a grid, no cell twice.
struct Placement {
  Spot cells;  ///< per axis; as many as vertices or a few more
  std::vector<Spot> of;
};

/// Places neighbours near one another.
/// @param steps_per_vertex  proposals of the annealing for each vertex; 0: a random placement.
/// Cost: O(n) memory, the proposals in time, each O(degree).
Placement place(const Graph& graph, std::uint64_t steps_per_vertex, RandomStream random);

}  // namespace ar3d::routed
