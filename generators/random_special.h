#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// Uniform over the connected labelled simple d-regular graphs: random regular graphs until one is
/// connected (nearly always the first for large n and d >= 3). @throws InputError as
/// random_regular, and for d < 3.
Graph random_connected_regular(Count n, std::uint32_t d, std::uint64_t seed);

/// Uniform over the simple cubic bipartite graphs with sides 0..s-1 and s..2s-1, s = n/2: the
/// points of one side are matched with a random permutation of those of the other, repeated until
/// simple (probability tends to e^-2). n even, n >= 6.
Graph random_bipartite_cubic(Count n, std::uint64_t seed);

/// The graph with each edge kept with probability per_million / 10^6, independently.
Graph thinned(const Graph& graph, std::uint32_t per_million, std::uint64_t seed);

/// A random tree of maximum degree D in 2..4: vertex v = 1, 2, ... is joined to a uniformly random
/// one of the earlier vertices of degree below D. n - 1 edges, all bridges.
Graph random_tree(Count n, Count D, std::uint64_t seed);

/// A connected cubic graph with exactly `bridges` bridges: bridges + 1 pieces form a random
/// recursive tree; every piece is a uniformly random connected bridgeless cubic graph; a bridge
/// joins new vertices that subdivide uniformly random edges of its two pieces; spare vertices are
/// dealt to the pieces in pairs, uniformly. n even, n >= 6 bridges + 4.
/// @throws InputError if n is odd or too small.
Graph random_cubic_with_bridges(Count n, Count bridges, std::uint64_t seed);

}  // namespace ar3d
