#pragma once

#include "ar3d/generators/graph_builder.h"

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

}  // namespace ar3d
