#include "ar3d/generators/patches.h"

namespace ar3d {

Graph square_grid(Count rows, Count columns) {
  GraphBuilder builder(rows * columns, 2 * rows * columns);
  for (Count r = 0; r < rows; ++r) {
    builder.path(r * columns, columns);
    if (r == 0) continue;
    for (Count c = 0; c < columns; ++c) builder.edge((r - 1) * columns + c, r * columns + c);
  }
  return builder.finish();
}

Graph torus(Count rows, Count columns) {
  GraphBuilder builder(rows * columns, 2 * rows * columns);
  for (Count r = 0; r < rows; ++r) {
    builder.cycle(r * columns, columns);
    const Count below = (r + 1) % rows;
    for (Count c = 0; c < columns; ++c) builder.edge(r * columns + c, below * columns + c);
  }
  return builder.finish();
}

}  // namespace ar3d
