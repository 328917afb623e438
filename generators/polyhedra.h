#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// `depth` triangles, each joined to the next by three edges (C_3 x P_depth): planar, 3-connected
/// for depth >= 2, maximum degree 4 for depth >= 3. Planar straight-line drawings of nested
/// triangles need a quadratic area. n = 3 depth, m = 6 depth - 3.
Graph nested_triangles(Count depth);

/// The truncation of a cubic graph: every vertex becomes a triangle. n' = 3n, m' = 3n'/2, cubic;
/// planar, 3-connected and bridgeless if the graph is. @throws InputError if a vertex has another
/// degree than 3.
Graph truncated(const Graph& cubic);

/// K4 truncated until it has n = 4 3^t vertices: cubic, planar, 3-connected.
Graph iterated_truncation(Count n);

/// K4, whose innermost vertex is truncated `depth` times: triangles inside one another, each of two
/// new vertices and an old one. Cubic, planar, 3-connected; n = 4 + 2 depth.
Graph nested_truncation(Count depth);

/// A fullerene tube: a cap of one `around`-gon at each end and `rings` >= 1 cycles of 2 around
/// vertices between them. n = 2 around (rings + 1), cubic, planar, 3-connected; two `around`-gons,
/// 2 around pentagons, hexagons. around = 5 is the (5, 0) nanotube (rings = 1: the dodecahedron),
/// around = 6 the (6, 0) nanotube.
Graph nanotube(Count around, Count rings);

/// The icosahedral fullerenes GC_{a,b} of the dodecahedron (Goldberg 1937, Coxeter 1971), for
/// a >= 1 and 0 <= b <= a: n = 20 (a^2 + ab + b^2). Cubic, planar, 3-connected, 12 pentagons, all
/// other faces hexagons, the 60 rotations of the icosahedron and, if b = 0 or a = b, its
/// reflections. (1, 0) is the dodecahedron, (1, 1) C60.
/// @throws InputError if a or b is out of range or a > 8000. Cost: O(n log n).
Graph goldberg_coxeter(Count a, Count b);

}  // namespace ar3d
