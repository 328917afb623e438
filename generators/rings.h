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

}  // namespace ar3d
