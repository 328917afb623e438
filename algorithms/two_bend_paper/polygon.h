#pragma once

#include <vector>

#include "ar3d/algorithms/two_bend_paper/placement.h"

namespace ar3d::two_bend_paper {

/// The polygon of a cycle (Step P.5): one vertex on each of its L axis-parallel sides, which
/// alternate with diagonals: a staircase of L - 3 sides towards the east, then one side towards the
/// north, the west and the south. It lies right of all feet.
/// @param feet  all active ones, in the frame in which it lies to their right.
/// @param needs_position  for every vertex whether it must keep general position.
/// @throws InternalError if no place is found.
std::vector<Side> cycle_polygon(const std::vector<Foot>& feet,
                                const std::vector<bool>& needs_position);

/// Right of all feet, by 1 to 2, and at their middle height, both integers. The origin without
/// feet.
Foot right_of(const std::vector<Foot>& feet);

}  // namespace ar3d::two_bend_paper
