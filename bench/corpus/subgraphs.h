#pragma once

#include <cstdint>

#include "ar3d/model/graph.h"

namespace ar3d {

/// The largest connected component, its vertices renumbered in their order; of equally large ones
/// the one with the smallest vertex. The graph itself if it is connected. O(n + m).
Graph largest_component(const Graph& graph);

/// The subgraph that the first `n` vertices of a breadth-first search induce (from vertex 0, then
/// from the smallest vertex left), numbered as they are found; the graph itself if it has no more.
/// Degrees only fall. O(n + m).
Graph breadth_first_piece(const Graph& graph, std::uint64_t n);

}  // namespace ar3d
