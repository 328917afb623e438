#pragma once

#include <vector>

#include "ar3d/generators/graph_builder.h"
#include "ar3d/model/drawing.h"

namespace ar3d {

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
