#pragma once

#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// A uniformly random labelled simple d-regular graph (pairing model, see pairing.h). m = dn/2; for
/// large n it is d-connected, hence without bridges, with probability 1 - O(1/n) (Bollobas 1981;
/// Wormald 1981); d = 1, 2: matchings, cycles.
/// @throws InputError unless 1 <= d <= 4, n > d and dn is even.
Graph random_regular(Count n, std::uint32_t d, std::uint64_t seed);

/// The edges of the same, for arguments that were checked: by full restart for small n, by
/// switchings (switching.h) for n >= 200; both are exactly uniform.
std::vector<Edge> random_regular_edges(Count n, std::uint32_t d, RandomStream& random);

/// A random simple graph with maximum degree at most D and exactly m edges: every vertex has D
/// points, a uniformly random pairing of all points is drawn, its first m pairs are the edges, and
/// all of it is repeated until the graph is simple. So P(G) is proportional to the product over v
/// of 1 / (D - deg v)!: uniform over the graphs with the same degrees, uniform at all for D = 1 and
/// for D-regular graphs.
/// @throws InputError unless 1 <= D <= 4 and m is at most the size of the largest such graph.
Graph random_max_degree(Count n, std::uint32_t D, Count m, std::uint64_t seed);

/// Number of edges of a largest simple graph with n vertices and maximum degree D.
Count most_edges(Count n, std::uint32_t D);

}  // namespace ar3d
