#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/generators/graph_builder.h"
#include "ar3d/model/drawing.h"

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
/// 4-regular, n = 6k, k >= 2, m = 2n, 2-connected. Labels: first the vertices with even index on the
/// cycle, then those with odd index; so `diamond` pairs the triangles' edges with each other and
/// colours them green, and the cycle red. Every triangle is then a green cycle contained in a red
/// one, cannot be closed at two of its three edges, and has a Z with |dX| = 2, |dY| = 4.
Graph contained_cycles(Count k);

/// Copies of triangle, K4, two leaf blocks joined by a bridge, prism, Petersen graph and triangle
/// in turn (36 vertices per round): small dense components of many kinds, each of which forces the
/// drawers' special cases. The bridged one and the Petersen graph have no 3-edge-colouring, so they
/// give `grid` at least 4 defects a round. n = 36 k.
Graph mixed_union(Count k);

/// The square patch P_rows x P_columns: maximum degree 4, 2-connected for rows, columns >= 2.
/// m = rows (columns - 1) + (rows - 1) columns. rows, columns >= 1.
Graph square_grid(Count rows, Count columns);

/// The torus C_rows x C_columns: 4-regular, 4-connected, m = 2n. rows, columns >= 3.
Graph torus(Count rows, Count columns);

/// The hexagonal patch of the honeycomb with k hexagons on a side: n = 6k^2, m = 9k^2 - 3k, maximum
/// degree 3, 2-connected, planar, girth 6. (The honeycomb network of Stojmenovic 1997.) k >= 1.
Graph honeycomb(Count k);

/// The hypercube Q_d: n = 2^d, d-regular and d-connected. d in 0..4.
Graph hypercube(Count d);

/// The first n vertices of the diamond lattice in breadth-first order from the origin: connected,
/// bipartite, maximum degree 4, girth 6. Edges are the vectors (1,1,1), (1,-1,-1), (-1,1,-1),
/// (-1,-1,1) or their negatives: all angles arccos(-1/3). With their points
/// on the unit cube grid. n >= 1. Cost: O(n) expected.
std::pair<Graph, std::vector<Point>> diamond_lattice_piece(Count n);

/// The same of the Laves graph (the K4 crystal, Sunada 2008): maximum degree 3, girth 10, edges are
/// face diagonals of the cube grid, the three at a vertex lie in a plane: all angles 120 degrees.
std::pair<Graph, std::vector<Point>> laves_piece(Count n);

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

/// Disjoint stars K_{1,leaves}: `copies` components, every edge a bridge. n = copies (leaves + 1).
/// leaves in 1..4 (1: a perfect matching).
Graph stars(Count copies, Count leaves);

/// A spine of k >= 1 vertices with `legs` pendant vertices each: a tree of maximum degree legs + 2.
/// n = k (legs + 1). legs in 1..2.
Graph caterpillar(Count k, Count legs);

/// The heap-shaped tree: the parent of v >= 1 is (v - 1)/2. Maximum degree 3. n >= 1.
Graph binary_tree(Count n);

/// A spine of 3k vertices; spine vertex i carries a pendant heap-shaped tree of 3, 5 or 9 vertices
/// (i mod 3). n = 20k, a tree of maximum degree 3. On such graphs the pendant trees force one label
/// on the whole spine, and a drawer on the cube grid that places "low" planes relative to one
/// another piles up Theta(n) steps. k >= 1.
Graph spine_with_pendant_trees(Count k);

/// A smallest cubic "leaf block": a cubic graph with one edge subdivided, whose vertex of degree 2
/// (number 0) takes the bridge. 5 vertices: K4 subdivided; 7 vertices: K3,3 subdivided.
/// @throws InputError for another size.
Graph leaf_block(Count size);

enum class TreeShape {
  kBalanced,  ///< breadth first
  kPath,      ///< a caterpillar
  kRandom     ///< every new inner vertex at a uniformly random open end
};

/// A cubic graph whose bridges form a tree: `inner` vertices that lie on three bridges, `inner` + 2
/// leaf blocks, of which the first `large_blocks` have 7 vertices and the others 5 (in random
/// places for kRandom). n = 6 inner + 10 + 2 large_blocks, m = 3n/2, connected, 2 inner + 1
/// bridges. With inner = 0 two blocks share a bridge. Cubic graphs with many bridges have no
/// perfect matching once three odd blocks meet (Sylvester 1883).
/// @throws InputError if large_blocks > inner + 2.
Graph cubic_tree(Count inner, Count large_blocks, TreeShape shape, std::uint64_t seed = 0);

/// A generalised Blanusa snark: a chain of k + 1 Petersen graphs by dot products, each cut in two
/// edges at distance `type` = 1 or 2. n = 8k + 10, m = 3n/2, cubic, no bridges, no
/// 3-edge-colouring. k = 1: the two Blanusa snarks (1946).
/// @throws InputError unless type is 1 or 2. O(k).
Graph blanusa_snark(Count k, Count type);

/// Goldberg's snark G_k (1981): k blocks of 8 vertices in a ring. n = 8k, m = 12k, cubic, no
/// bridges, no 3-edge-colouring.
/// @throws InputError unless k is odd and at least 5.
Graph goldberg_snark(Count k);

/// The double-star snark (Isaacs 1975): 30 vertices, girth 6, diameter 4.
Graph double_star_snark();

/// The Szekeres snark (1973): 50 vertices, girth 5, diameter 7.
Graph szekeres_snark();

/// The Watkins snark (1989): 50 vertices, girth 5, diameter 7.
Graph watkins_snark();

/// The cubic graph of LCF notation (Lederberg, Coxeter, Frucht): the cycle 0..n-1 and, for every i,
/// the chord from i to i + shifts[i mod shifts.size()], n = shifts.size() repeats. Every chord is
/// met from both of its ends.
/// @throws InputError if a chord is not met again from its other end, or is a loop or an edge of
/// the cycle.
Graph lcf_graph(const std::vector<int>& shifts, Count repeats);

/// One graph with a name of its own.
struct NamedGraph {
  std::string name;
  std::string summary;  ///< one sentence: what it is, with its source
  Vertex num_vertices = 0;
  std::function<Graph()> make;
};

/// All of them, in order of size.
const std::vector<NamedGraph>& named_graphs();

}  // namespace ar3d
