#pragma once

#include <vector>

#include "ar3d/algorithms/grid_paper/grid_paper.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid_paper {

/// Holds what one stage adds to the set S of vertices that are drawn, in this order. Then every
/// vertex outside has two neighbours outside, hence at most one in S.
struct GrowthStage {
  std::vector<Vertex> cycle;  ///< without chord, in cyclic order; empty in the first stage
  std::vector<Vertex>
      between;  ///< they have a neighbour on the cycle and one in the old S; ascending
  std::vector<Vertex> closure;  ///< those that wait (Repair G.12), then first in, first out
};

/// The stages of a connected component; all its vertices are in them.
struct ComponentGrowth {
  std::vector<Vertex> vertices;  ///< ascending
  std::vector<GrowthStage> stages;
};

/// Steps G.1 and G.2: components in the order of their least vertices. Cost: that of the cycles,
/// and O(n log n). @param any_cycle  of the options.
std::vector<ComponentGrowth> grow(const Graph& graph, bool any_cycle,
                                  const RepairSwitches& repairs);

}  // namespace ar3d::grid_paper
