#pragma once

#include <optional>

#include "ar3d/algorithms/routed/negotiation.h"
#include "ar3d/algorithms/routed/placement.h"

namespace ar3d::routed {

/// The placement at the scale of a box, each vertex at the nearest point that is free and, if
/// possible, beside no other vertex. Frames are those of choose_frames().
/// @return none if the box has too few points. Cost: O(points tried), a few for each vertex.
std::optional<Layout> spread(const PointClass& points, const Placement& placement,
                             std::vector<std::uint8_t> frames, const Limits& limits);

/// A layout at the scale of another box, likewise.
std::optional<Layout> rescaled(const PointClass& points, const Layout& layout,
                               const Limits& limits);

/// A routing without what lies outside of a smaller box: vertices there go to the nearest free
/// point inside, and routes that pass there are taken away.
/// @return none if the box has too few points.
std::optional<Routing> cut(const Graph& graph, const PointClass& points, Routing routing,
                           const Limits& limits);

/// Random frames for face diagonals; one for all for body diagonals, with which every edge has an
/// odd number of bends, but with four bends a cut that many edges cross.
std::vector<std::uint8_t> choose_frames(const Graph& graph, const PointClass& points, int bends,
                                        RandomStream random);

/// The smallest box of all vertices and routes of a graph with vertices.
Limits tight_limits(const Graph& graph, const PointClass& points, const Routing& routing);

}  // namespace ar3d::routed
