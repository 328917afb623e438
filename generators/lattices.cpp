// Pieces of lattices. The diamond lattice and the Laves graph are grown breadth-first from the
// origin, with a hash table of points: their own straight drawing is the optimum to compare with.
#include <unordered_map>

#include "ar3d/generators/families.h"

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

namespace {

/// Breadth-first piece of n vertices; steps(p) gives the edge vectors at p in a fixed order. Every
/// edge between two of its vertices belongs to the piece and is entered when the later end is
/// expanded.
template <class Steps>
std::pair<Graph, std::vector<Point>> breadth_first_piece(Count n, Steps steps) {
  std::vector<Point> positions;
  std::unordered_map<Point, Count, PointHash> number(n);
  positions.reserve(n);
  positions.push_back({});
  number.emplace(Point{}, 0);
  GraphBuilder builder(n, 2 * n);
  for (Count v = 0; v < positions.size(); ++v) {
    const Point at = positions[v];
    for (const Vector step : steps(at)) {
      const auto known = number.find(at + step);
      if (known != number.end()) {
        if (known->second < v) builder.edge(known->second, v);
      } else if (positions.size() < n) {
        number.emplace(at + step, positions.size());
        positions.push_back(at + step);
      }
    }
  }
  return {builder.finish(), std::move(positions)};
}

std::vector<Vector> diamond_steps(Point p) {
  const std::int64_t s =
      p.x % 2 == 0 ? 1 : -1;  // the two kinds of vertices: all coordinates even, all odd
  return {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
}

/// Vertices of the Laves graph modulo 4 in every coordinate; neighbours are those at distance
/// sqrt 2.
bool in_laves_graph(Point p) {
  constexpr int kClasses[8][3] = {{0, 0, 0}, {1, 2, 3}, {2, 3, 1}, {3, 1, 2},
                                  {2, 2, 2}, {3, 0, 1}, {0, 1, 3}, {1, 3, 0}};
  const auto same = [](std::int64_t c, int residue) { return ((c - residue) & 3) == 0; };
  return std::any_of(std::begin(kClasses), std::end(kClasses), [&](const int* c) {
    return same(p.x, c[0]) && same(p.y, c[1]) && same(p.z, c[2]);
  });
}

std::vector<Vector> laves_steps(Point p) {
  std::vector<Vector> steps;
  for (const std::int64_t a : {-1, 1}) {
    for (const std::int64_t b : {-1, 1}) {
      for (const Vector step : {Vector{a, b, 0}, Vector{a, 0, b}, Vector{0, a, b}}) {
        if (in_laves_graph(p + step)) steps.push_back(step);
      }
    }
  }
  return steps;
}

}  // namespace

std::pair<Graph, std::vector<Point>> diamond_lattice_piece(Count n) {
  return breadth_first_piece(n, diamond_steps);
}

std::pair<Graph, std::vector<Point>> laves_piece(Count n) {
  return breadth_first_piece(n, laves_steps);
}

}  // namespace ar3d
