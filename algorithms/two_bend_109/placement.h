#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/algorithms/two_bend_109/drawn_segments.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend_109 {

/// Holds where everything stands, each component by itself.
struct Placement {
  explicit Placement(Vertex num_vertices) : at(num_vertices), ends(num_vertices) {}
  std::vector<Point> at;                   ///< of each vertex
  std::vector<std::array<Point, 4>> ends;  ///< entry i of a vertex: the bend next to it on its i-th
                                           ///< incident edge
  std::int64_t tried = 0;                  ///< points tried in all, for what could be placed
};

/// owners_that_meet(), or what tests compare it with.
using MeetingSearch = decltype(owners_that_meet);

/// Each vertex and body takes a point of its square where no new middle is flat and nothing new
/// meets anything older, by Step E.4; false if some square is seen to be too small. At the scale
/// LayoutScale::always_enough(n) none is (Lemma E.5). Takes O(n) and `find`, in each round.
/// @param parts  of one component, of n vertices.
/// @param seed  on which the choices depend, and on the numbers within the component.
/// @param made  has room for the graph, and nothing else in it changes.
bool place(const OrderedGraph& graph, std::span<const VertexPart> parts,
           const SlotArrangement& arrangement, const Layout& layout, std::uint64_t seed,
           Placement& made, MeetingSearch& find = owners_that_meet);

}  // namespace ar3d::two_bend_109
