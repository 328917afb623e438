#pragma once

#include <cstdint>
#include <functional>

#include "ar3d/model/graph.h"

namespace ar3d {

struct ShrinkResult {
  Graph graph;
  std::uint64_t evaluations = 0;
  bool minimal = false;  ///< no vertex and no edge can go; false if the evaluations ran out
};

/// Removes components, vertices and edges as long as `keeps` holds (delta debugging: Zeller and
/// Hildebrandt 2002, first large chunks, then small ones). What stays keeps its order. Degrees only
/// fall, so the graph stays inside every guarantee.
/// @param keeps  the property; true of `graph`.
/// Cost: O(k log k) evaluations for k vertices and edges where few stay, O(k^2) at worst.
ShrinkResult shrink(const Graph& graph, const std::function<bool(const Graph&)>& keeps,
                    std::uint64_t max_evaluations);

}  // namespace ar3d
