#pragma once

// Theorem 1, last steps: the ends' labels, a track for every edge, and the routes in space.

#include <array>

#include "ar3d/algorithms/diamond/placement.h"
#include "ar3d/model/drawing.h"

namespace ar3d::diamond {

/// One number per edge. A green edge uv runs in the plane from u vertically to the line Y = track,
/// along it, and vertically to v; a red one horizontally to X = track and back. It is drawn as U
/// (track beyond both ends) or as Z (between). Invariants: the two green ends at a vertex leave to
/// opposite sides, and the two red ones; no apex is on a turn.
struct Tracks {
  UnwrittenVector<std::int32_t> code;     ///< by edge: 2 * track + colour
  std::array<std::int64_t, 3> extents{};  ///< of the drawing in space, bends included
};

/// Along an item, a U flips the side on which the next edge starts and a Z keeps it; a path is all
/// U; a cycle closes with a U beyond everything else of it, which an all-U labelling allows iff its
/// length is even; an odd cycle takes one Z. O(n + m).
Tracks choose_tracks(const Graph& graph, const Placement& placement);

/// The drawing in space: vertices (X - Y, X + Y, 0); the height over a green edge is its distance
/// from the nearer end in the plane, red edges run below. 4 bytes per edge besides the graph's own
/// edge list.
Drawing lift(const Graph& graph, const Placement& placement, Tracks tracks);

}  // namespace ar3d::diamond
