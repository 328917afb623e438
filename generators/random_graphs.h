#pragma once

#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/generators/graph_builder.h"
#include "ar3d/model/graph.h"

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

/// A uniformly random labelled simple d-regular graph (pairing model, random_simple_pairs). m =
/// dn/2; for large n it is d-connected, hence without bridges, with probability 1 - O(1/n)
/// (Bollobas 1981; Wormald 1981); d = 1, 2: matchings, cycles.
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

/// The graph with its labels permuted, all permutations being equally likely. The edges keep their
/// order. O(n + m).
Graph shuffled_labels(const Graph& graph, RandomStream& random);

}  // namespace ar3d
