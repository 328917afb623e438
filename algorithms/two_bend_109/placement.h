#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend_109 {

/// Holds where everything stands: the drawing of a connected graph.
struct Placement {
  std::vector<Point> at;                   ///< of each vertex
  std::vector<std::array<Point, 4>> ends;  ///< entry i of a vertex: the bend next to it on its i-th
                                           ///< incident edge
  std::int64_t tried = 0;                  ///< points tried in all
};

/// Each vertex in turn takes the first point of its square, in a fixed pseudo-random order, where
/// nothing new meets anything; nothing if some vertex finds none. At
/// the scale LayoutScale::always_enough(n) each finds one (Lemma E.5).
/// @param is_filtered  see DrawnSegments; the placement is the same. Cost: O(n) per point tried.
std::optional<Placement> place(const Graph& graph, const std::vector<VertexPart>& parts,
                               const SlotArrangement& arrangement, const Layout& layout,
                               std::uint64_t seed, bool is_filtered = true);

}  // namespace ar3d::two_bend_109
