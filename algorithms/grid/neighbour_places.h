#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "ar3d/algorithms/grid/order.h"
#include "ar3d/base/threads.h"
#include "ar3d/model/graph.h"

namespace ar3d::grid {

/// A vertex's place in the processing order: its index in ProcessingOrder::sequence.
using Place = std::uint32_t;
inline constexpr Place kAhead = 8;  ///< places between asking for memory and using it
inline constexpr Place kNoPlace = std::numeric_limits<Place>::max();

/// A stretch [begin, end) of places: one component.
struct PlaceRange {
  Place begin = 0;
  Place end = 0;
  std::int64_t size() const { return std::int64_t{end} - begin; }
};

/// The neighbours of one vertex as places, in the order of the graph's row.
struct NeighbourPlaces {
  std::array<Place, 3> to{};
  std::array<EdgeId, 3> edge{};
  std::uint32_t degree = 0;
};

/// The graph renumbered in processing order, so that later stages read memory forwards and
/// "earlier" is a comparison of places. Cost: O(n + m).
UnwrittenVector<NeighbourPlaces> neighbours_in_order(const Graph& graph,
                                                     const ProcessingOrder& order);

}  // namespace ar3d::grid
