#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// `copies` disjoint copies of `part`, vertices numbered one copy after the other.
Graph copies_of(const Graph& part, Count copies);

/// The complete graph on n <= 5 vertices.
Graph complete_graph(Count n);

/// The complete bipartite graph with sides 0..a-1 and a..a+b-1.
Graph complete_bipartite(Count a, Count b);

/// The octahedron K_{2,2,2}: 4-regular on 6 vertices; opposite corners sum to 5.
Graph octahedron_graph();

/// The odd graph O_k, k-regular: the (k - 1)-subsets of 2k - 1 things in order of their bit masks,
/// joined if disjoint (Kneser). O_2 is a triangle, O_3 the Petersen graph, O_4 4-regular on 35
/// vertices. k in 2..4.
Graph odd_graph(unsigned k);

/// A chain of `links` diamonds (K4 without an edge) between two 5-vertex leaf blocks, joined by
/// bridges. n = 4 links + 10, m = 3n/2, cubic, connected, links + 1 bridges.
Graph block_chain(Count links);

/// A ring of k >= 2 diamonds (K4 without an edge): n = 4k, m = 6k, cubic, 2-connected, no bridges.
Graph diamond_necklace(Count k);

/// A random cactus: cycles of `length` >= 3 vertices, every new one glued to a uniformly random
/// vertex that lies on one cycle so far. n = length + (cycles - 1)(length - 1), m = cycles length,
/// connected, degrees 2 and 4, no bridges. cycles >= 1.
Graph random_cactus(Count cycles, Count length, std::uint64_t seed);

/// A long cycle whose vertices carry triangles (0, 2, 4) and (1, 3, 5) in every six along it:
/// 4-regular, n = 6k, k >= 2, m = 2n, 2-connected. Labels: first the vertices at even places of the
/// cycle, then those at odd places; so `diamond` pairs the triangles' edges with each other and
/// colours them green, and the cycle red. Every triangle is then a green cycle contained in a red
/// one, cannot be closed at two of its three edges, and has a Z with |dX| = 2, |dY| = 4.
Graph contained_cycles(Count k);

/// Copies of triangle, K4, two leaf blocks joined by a bridge, prism, Petersen graph and triangle
/// in turn (36 vertices per round): small dense components of many kinds, each of which forces the
/// drawers' special cases. The bridged one and the Petersen graph have no 3-edge-colouring, so they
/// give `grid` at least 4 defects a round. n = 36 k.
Graph mixed_union(Count k);

}  // namespace ar3d
