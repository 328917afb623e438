#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// The path on n vertices: n - 1 edges, all bridges. n >= 1.
Graph path_graph(Count n);

/// The cycle on n vertices: n edges, 2-connected. n >= 3.
Graph cycle_graph(Count n);

/// The ladder P_2 x P_k: n = 2k, m = 3k - 2, maximum degree 3, 2-connected for k >= 2. k >= 1.
Graph ladder(Count k);

/// The prism C_k x K_2: n = 2k, m = 3k, cubic, 3-connected, planar. k >= 3.
Graph prism(Count k);

/// The Moebius ladder: the cycle on 2k vertices with its k long diagonals; cubic, 3-connected, not
/// planar for k >= 3. n = 2k, m = 3k. k >= 2 (k = 2 gives K4, k = 3 gives K3,3).
Graph moebius_ladder(Count k);

/// The circulant graph C_n(a, b): i is joined to i +- a and i +- b modulo n. 4-regular where a, b
/// and their negatives are four different residues, cubic where 2b = n; connected iff gcd(n, a, b)
/// = 1. No bridges.
/// @throws InputError unless 1 <= a < b <= n/2.
Graph circulant(Count n, Count a, Count b);

/// The squared cycle C_n(1, 2): 4-regular, 4-connected; the antiprism for even n. n >= 5.
Graph squared_cycle(Count n);

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
