#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// The generalised Petersen graph GP(N, k) (Watkins 1969): an outer cycle u_0..u_{N-1}, spokes u_i
/// v_i and inner edges v_i v_{i+k}. n = 2N, m = 3N, cubic, connected, no bridges. GP(5, 2) is the
/// Petersen graph.
/// @throws InputError unless N >= 3 and 1 <= k < N/2.
Graph generalised_petersen(Count N, Count k);

/// The I-graph I(N, j, k) (Foster census, 1988): as GP(N, k), but the outer edges are u_i u_{i+j}.
/// Cubic, no bridges, gcd(N, j, k) components.
/// @throws InputError unless N >= 3 and 1 <= j, k < N/2.
Graph i_graph(Count N, Count j, Count k);

/// Isaacs' flower snark J_k (1975): k claws with centres a_i and leaves b_i, c_i, d_i; the b_i form
/// one cycle, c_0..c_{k-1} d_0..d_{k-1} another. n = 4k, m = 6k, cubic, 3-connected, no bridges; no
/// 3-edge-colouring for odd k; girth 5 for k = 5, 6 for k >= 7. J_3 contains a triangle.
/// @throws InputError unless k is odd and at least 3.
Graph flower_snark(Count k);

}  // namespace ar3d
