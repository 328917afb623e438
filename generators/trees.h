#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

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

}  // namespace ar3d
