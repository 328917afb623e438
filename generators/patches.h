#pragma once

#include "ar3d/generators/graph_builder.h"

namespace ar3d {

/// The square patch P_rows x P_columns: maximum degree 4, 2-connected for rows, columns >= 2.
/// m = rows (columns - 1) + (rows - 1) columns. rows, columns >= 1.
Graph square_grid(Count rows, Count columns);

/// The torus C_rows x C_columns: 4-regular, 4-connected, m = 2n. rows, columns >= 3.
Graph torus(Count rows, Count columns);

}  // namespace ar3d
