#pragma once

// Steps 1.1 and 1.2 for large graphs: the same colouring and the same items as colouring.h and
// items.h, found by many walks at the same time.

#include "ar3d/algorithms/diamond/colouring.h"
#include "ar3d/algorithms/diamond/items.h"
#include "ar3d/algorithms/diamond/walk_lanes.h"

namespace ar3d::diamond {

/// From so many vertices on many walks at a time are faster in Step 1.1, and in Step 1.2.
inline constexpr Vertex kManyToColour = 1u << 12;
inline constexpr Vertex kManyInItems = 1u << 15;

/// two_colouring() of the graph, by many walks or by one, whichever is faster. Cost: O(n + m).
/// @param graph  of maximum degree at most 4, n <= 2^27.
TwoColouring colouring_of(const Graph& graph);

/// two_colouring() of the graph. Cost: O(n + m), and 25 bytes per vertex while it runs.
/// @param graph  of maximum degree at most 4, n <= 2^27.
TwoColouring interleaved_colouring(const Graph& graph, const WalkSizes& sizes = {});

/// extract_items(next). Cost: O(n).
Items interleaved_items(const std::vector<HalfEdge>& next, const WalkSizes& sizes = {});

}  // namespace ar3d::diamond
