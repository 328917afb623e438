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

Graph honeycomb(Count k) {
  // Vertices are the integer points with 1 - k <= x, y, z <= k and x + y + z = 1 or 2, shifted by k
  // - 1 >= 0; edges have length 1.
  const Count width = 2 * k;
  constexpr Count kNone = ~Count{0};
  std::vector<Count> number(width * width * 2, kNone);
  const Count sum = 3 * (k - 1) + 1;
  GraphBuilder builder(6 * k * k, 9 * k * k);
  Count next = 0;
  const auto at = [&](Count x, Count y, Count level) -> Count& {
    return number[(x * width + y) * 2 + level];
  };
  for (Count x = 0; x < width; ++x) {
    for (Count y = 0; y < width; ++y) {
      for (Count level = 0; level < 2; ++level) {
        if (x + y <= sum + level && sum + level - x - y < width) at(x, y, level) = next++;
      }
    }
  }
  const auto join = [&](Count u, Count v) {
    if (u != kNone && v != kNone) builder.edge(u, v);
  };
  for (Count x = 0; x < width; ++x) {
    for (Count y = 0; y < width; ++y) {
      join(at(x, y, 0), at(x, y, 1));  // z grows
      if (x + 1 < width) join(at(x, y, 0), at(x + 1, y, 1));
      if (y + 1 < width) join(at(x, y, 0), at(x, y + 1, 1));
    }
  }
  return builder.finish();
}

Graph hypercube(Count d) {
  GraphBuilder builder(Count{1} << d);
  for (Count v = 0; v < builder.num_vertices(); ++v) {
    for (Count bit = 0; bit < d; ++bit) {
      const Count other = v ^ (Count{1} << bit);
      if (v < other) builder.edge(v, other);
    }
  }
  return builder.finish();
}

}  // namespace ar3d
