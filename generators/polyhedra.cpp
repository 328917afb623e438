#include "ar3d/generators/polyhedra.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "ar3d/generators/unions.h"
#include "ar3d/model/error.h"

namespace ar3d {
namespace {

using Corner = std::array<Count, 3>;  // a vertex of the subdivided icosahedron, canonical
using Triangle = std::array<Corner, 3>;

constexpr Count kNoCorner = 12;

std::vector<std::array<Count, 3>> icosahedron() {
  std::vector<std::array<Count, 3>> faces;  // 0 top, 1..5 and 6..10 the rings, 11 bottom
  for (Count i = 0; i < 5; ++i) {
    const Count j = (i + 1) % 5;
    faces.push_back({0, 1 + i, 1 + j});
    faces.push_back({1 + i, 1 + j, 6 + i});
    faces.push_back({6 + i, 6 + j, 1 + j});
    faces.push_back({11, 6 + i, 6 + j});
  }
  return faces;
}

/// The point with barycentric weights w (sum a) in a face of the icosahedron, the same name from
/// every face that holds it: corners are (corner, 12, 0), points on an edge (low end, high end,
/// weight of the high end), inner points (12 + face, w0, w1).
Corner corner_name(const std::array<Count, 3>& face, Count face_number, std::array<Count, 3> w) {
  std::vector<std::pair<Count, Count>> support;  // corner, weight
  for (std::size_t i = 0; i < 3; ++i) {
    if (w[i] > 0) support.emplace_back(face[i], w[i]);
  }
  std::sort(support.begin(), support.end());
  if (support.size() == 1) return {support[0].first, kNoCorner, 0};
  if (support.size() == 2) return {support[0].first, support[1].first, support[1].second};
  return {kNoCorner + 1 + face_number, w[0], w[1]};
}

/// Every face of the icosahedron cut into a^2 triangles.
std::vector<Triangle> geodesic_triangles(Count a) {
  std::vector<Triangle> triangles;
  const auto faces = icosahedron();
  for (Count f = 0; f < faces.size(); ++f) {
    const auto name = [&](Count i, Count j) { return corner_name(faces[f], f, {i, j, a - i - j}); };
    for (Count i = 0; i < a; ++i) {
      for (Count j = 0; i + j < a; ++j) {
        triangles.push_back({name(i, j), name(i + 1, j), name(i, j + 1)});
        if (i + j + 2 <= a)
          triangles.push_back({name(i + 1, j), name(i, j + 1), name(i + 1, j + 1)});
      }
    }
  }
  return triangles;
}

/// One side of a triangle, for matching with the same side of its neighbour.
struct Side {
  Corner low;
  Corner high;
  Count triangle = 0;
  Count number = 0;  // the side opposite corner `number`
  friend bool operator<(const Side& s, const Side& t) {
    return std::tie(s.low, s.high, s.triangle) < std::tie(t.low, t.high, t.triangle);
  }
};

/// The pairs of equal sides of neighbouring triangles.
std::vector<std::pair<Side, Side>> matched_sides(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  for (Count t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3]);
      sides.push_back({low, high, t, i});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::pair<Side, Side>> pairs;
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    expect(sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high,
           "every side of a closed triangulation lies in two triangles");
    pairs.emplace_back(sides[i], sides[i + 1]);
  }
  return pairs;
}

/// Vertices: darts (corner -> corner) of the triangulation, two a side. Two darts are joined if
/// they are each other's reverse or leave one corner along two sides of a triangle. (The truncation
/// of the triangulation.)
Graph leapfrog_graph(const std::vector<Triangle>& triangles) {
  const auto pairs = matched_sides(triangles);
  std::vector<std::array<Count, 3>> side_of(
      triangles.size());  // side opposite each corner -> its number
  for (Count s = 0; s < pairs.size(); ++s) {
    for (const Side& side : {pairs[s].first, pairs[s].second})
      side_of[side.triangle][side.number] = s;
  }
  const auto dart = [&](Count t, std::size_t from, std::size_t opposite) {
    const Count s = side_of[t][opposite];
    return 2 * s + (triangles[t][from] == pairs[s].first.low ? 0 : 1);
  };
  GraphBuilder builder(2 * pairs.size(), 3 * pairs.size());
  for (Count s = 0; s < pairs.size(); ++s) builder.edge(2 * s, 2 * s + 1);
  for (Count t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      builder.edge(dart(t, i, (i + 1) % 3), dart(t, i, (i + 2) % 3));
    }
  }
  return builder.finish();
}

}  // namespace

Graph nested_triangles(Count depth) {
  GraphBuilder builder(3 * depth, 6 * depth);
  for (Count d = 0; d < depth; ++d) {
    builder.cycle(3 * d, 3);
    for (Count i = 0; d > 0 && i < 3; ++i) builder.edge(3 * d - 3 + i, 3 * d + i);
  }
  return builder.finish();
}

Graph truncated(const Graph& cubic) {
  GraphBuilder builder(3 * Count{cubic.num_vertices()}, 3 * Count{cubic.num_edges()});
  std::vector<std::uint32_t> used(cubic.num_vertices(),
                                  0);  // corners of each triangle that have their edge
  for (Vertex v = 0; v < cubic.num_vertices(); ++v) {
    if (cubic.degree(v) != 3) {
      throw InputError(
          fmt::format("truncation: vertex {} has degree {}, not 3", v, cubic.degree(v)));
    }
    builder.cycle(3 * Count{v}, 3);
  }
  for (const auto [u, v] : cubic.edges()) {
    builder.edge(3 * Count{u} + used[u]++, 3 * Count{v} + used[v]++);
  }
  return builder.finish();
}

Graph iterated_truncation(Count times) {
  Graph graph = complete_graph(4);
  for (Count i = 0; i < times; ++i) graph = truncated(graph);
  return graph;
}

Graph nanotube(Count around, Count rings) {
  const Count ring = 2 * around;
  GraphBuilder builder(ring * (rings + 1), 3 * around * (rings + 1));
  const Count first_ring = around;
  const Count bottom = around + ring * rings;
  builder.cycle(0, around);
  for (Count r = 0; r < rings; ++r) {
    const Count start = first_ring + r * ring;
    builder.cycle(start, ring);
    for (Count i = 0; i < around; ++i) {  // even places look up, odd places down
      builder.edge(r == 0 ? i : start - ring + 2 * i + 1, start + 2 * i);
    }
  }
  builder.cycle(bottom, around);
  for (Count i = 0; i < around; ++i) builder.edge(bottom - ring + 2 * i + 1, bottom + i);
  return builder.finish();
}

Graph goldberg_coxeter(Count a, bool leapfrog) {
  const std::vector<Triangle> triangles = geodesic_triangles(a);
  if (leapfrog) return leapfrog_graph(triangles);
  GraphBuilder builder(triangles.size(), 3 * triangles.size() / 2);
  for (const auto& [side, same] : matched_sides(triangles))
    builder.edge(side.triangle, same.triangle);
  return builder.finish();
}

}  // namespace ar3d
