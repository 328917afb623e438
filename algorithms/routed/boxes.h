#pragma once

#include <optional>

#include "ar3d/algorithms/routed/negotiation.h"

namespace ar3d::routed {

/// Says what a search for a small box has done.
struct BoxCounts {
  std::int64_t boxes = 0;      ///< tried
  std::int64_t legal = 0;      ///< of them, those with a drawing
  std::int64_t bytes = 0;      ///< of the largest
  std::uint64_t searches = 0;  ///< for routes
  std::size_t conflicts = 0;   ///< edges in conflict when the last box that failed was given up
};

/// The first box that is tried for a graph with vertices.
Limits first_box(const PointClass& points, int bends, std::uint64_t n);

/// Routes a graph with vertices in boxes that get smaller.
/// @param effort      0: one legal box; else smaller ones for a count of searches.
/// @param most_bytes  no larger box is tried.
/// @return the smallest drawing found, checked by is_drawing(); none if no box was legal.
std::optional<Routing> smallest_routing(const Graph& graph, const PointClass& points, int bends,
                                        int effort, std::int64_t most_bytes, BoxCounts& counts);

}  // namespace ar3d::routed
