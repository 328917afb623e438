#pragma once

#include <cstddef>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/placement.h"

namespace ar3d::two_bend_paper {

/// What a figure of members has when it replaces a node.
struct Room {
  double radius = 0;         ///< a power of two; the figure stays within it
  bool is_straight = false;  ///< the node's two edges leave it at 180 degrees
};

/// The rooms of all contractions whose result is left in the contracted graph, by contraction
/// (Step P.9): the radius is at most a third of 1, of the lengths of the first pieces at the place,
/// and of its distance from every other segment of the component. Others get radius 0. Found in
/// double, on the drawing in double. Cost: O(m) for each of them.
std::vector<Room> top_rooms(const ContractedGraph& graph,
                            const std::vector<PlacedComponent>& components, std::size_t num_edges);

}  // namespace ar3d::two_bend_paper
