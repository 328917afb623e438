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

}  // namespace ar3d
