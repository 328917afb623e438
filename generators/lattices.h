#pragma once

#include <vector>

#include "ar3d/generators/graph_builder.h"
#include "ar3d/model/drawing.h"

namespace ar3d {

/// A piece of a lattice graph together with its own drawing without bends.
struct LatticePiece {
  Graph graph;
  std::vector<Point> positions;  ///< one per vertex, on the unit cube grid
};

/// The first n vertices of the diamond lattice in breadth-first order from the origin: connected,
/// bipartite, maximum degree 4, girth 6. Edges are the vectors (1,1,1), (1,-1,-1), (-1,1,-1),
/// (-1,-1,1) or their negatives: all angles arccos(-1/3). n >= 1. Cost: O(n) expected.
LatticePiece diamond_lattice_piece(Count n);

/// The same of the Laves graph (the K4 crystal, Sunada 2008): maximum degree 3, girth 10, edges are
/// face diagonals of the cube grid, the three at a vertex lie in a plane: all angles 120 degrees.
LatticePiece laves_piece(Count n);

/// The piece drawn where it stands, without bends; `name` is the drawing's algorithm name.
Drawing straight_drawing(const LatticePiece& piece, const char* name);

}  // namespace ar3d
