#pragma once

#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// The pairing model (Bollobas 1980) by full restart: every vertex has `d` points; a uniformly
/// random sequence of `pairs` disjoint pairs of points is drawn again and again until it gives a
/// simple graph. Hence a simple graph G with m = pairs edges comes with probability proportional to
/// the product over v of d! / (d - deg v)!; with pairs = num_vertices d / 2 it is
/// exactly uniform over the simple labelled `d`-regular graphs.
/// @return the edges (u, v), u < v, in order of u.
/// @param d  1..4.  @param pairs  <= num_vertices d / 2 such that a simple graph exists.
/// Cost: an attempt stops at its first loop or parallel edge. Expected attempts for large n: e^2
/// = 7.4 for cubic, e^(15/4) = 42.5 for 4-regular graphs, each broken off after about a third of
/// its pairs. 36 bytes per vertex for d = 3.
std::vector<Edge> random_simple_pairs(Count num_vertices, std::uint32_t d, Count pairs,
                                      RandomStream& random);

}  // namespace ar3d
