#pragma once

#include <compare>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/violation.h"

namespace ar3d::verify {

/// Does an angle keep the promise? @param order  of its cosine, which falls as the angle grows, to
/// the promised one.
inline bool keeps_angle(const Guarantee& guarantee, std::strong_ordering order) {
  return guarantee.angle_rule == AngleRule::exactly ? order == 0 : order <= 0;
}

// One function per promise; each adds what is broken to `findings` and may stop once these are
// done().

/// vertex_count, edge_set: the drawing has the graph's vertices and draws each of its edges exactly
/// once.
void check_graph(const Graph& graph, const Drawing& drawing, Findings& findings);

/// lattice: the drawing is in the metric that the guarantee speaks of (equal matrices up to a
/// common factor).
void check_lattice(const Drawing& drawing, const Guarantee& guarantee, Findings& findings);

/// coordinate_range: every vertex and bend is in range, which the exact arithmetic of the other
/// checks needs.
void check_coordinates(const Drawing& drawing, Findings& findings);

/// plane: all vertices have z = 0, if promised.
void check_plane(const Drawing& drawing, const Guarantee& guarantee, Findings& findings);

/// same_point: no two vertices coincide. O(n log n).
void check_distinct_vertices(const Drawing& drawing, Findings& findings);

/// bends, degenerate_segment.
void check_bends(const Drawing& drawing, const Guarantee& guarantee, Findings& findings);

/// direction: every segment is parallel to an allowed direction, if any are named.
void check_directions(const Segments& segments, const Guarantee& guarantee, Findings& findings);

/// bend_angle: consecutive segments of every edge meet at the promised angle.
void check_bend_angles(const Segments& segments, const Guarantee& guarantee, Findings& findings);

/// vertex_angle: any two segments that leave a vertex form the promised angle.
void check_vertex_angles(const Segments& segments, const Guarantee& guarantee, Findings& findings);

/// size: the extents keep the bound for graphs of this number of vertices.
void check_size(const Graph& graph, const Box& box, const Guarantee& guarantee, Findings& findings);

}  // namespace ar3d::verify
