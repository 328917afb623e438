// Planar cubic graphs. The fullerenes are the duals of triangulated icosahedra (Goldberg 1937,
// Coxeter 1971): every triangle gets one name for each of its corners in exact integers, and equal
// sides are matched by sorting, so no table of the faces' seams is needed.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <tuple>

#include "ar3d/base/error.h"
#include "ar3d/generators/families.h"

namespace ar3d {
namespace {

using Corner = std::array<Count, 3>;  // a vertex of the subdivided icosahedron, canonical
using Triangle = std::array<Corner, 3>;
using Weights = std::array<std::int64_t, 3>;  // barycentric coordinates times a common factor

constexpr Count kNoCorner = 12;
constexpr Count kMostSteps = 8000;  // 20 T <= 60 a^2 fits 32 bits

/// A face of the icosahedron. Where the order of its corners is clockwise, it is mirrored: in every
/// other one.
using Face = std::array<Count, 3>;

std::vector<Face> icosahedron() {
  std::vector<Face> faces;  // 0 top, 1..5 and 6..10 the rings, 11 bottom
  for (Count i = 0; i < 5; ++i) {
    const Count j = (i + 1) % 5;
    faces.push_back({0, 1 + i, 1 + j});
    faces.push_back({1 + i, 1 + j, 6 + i});
    faces.push_back({6 + i, 6 + j, 1 + j});
    faces.push_back({11, 6 + i, 6 + j});
  }
  return faces;
}

/// The icosahedron's faces spread with the triangular lattice so that the corners of each are
/// lattice points apart by a + b zeta, zeta = exp(i pi / 3): T = a^2 + ab + b^2 lattice triangles
/// cover a face. (Coxeter 1971; Caspar and Klug 1962.)
class GeodesicSphere {
 public:
  GeodesicSphere(Count a, Count b)
      : a_(static_cast<std::int64_t>(a)),
        b_(static_cast<std::int64_t>(b)),
        faces_(icosahedron()),
        across_(faces_.size()) {
    for (Count f = 0; f < faces_.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) across_[f][k] = face_across(f, k);
    }
  }

  /// The 20 T lattice triangles. Each is counted to the face that holds its centre, to the first of
  /// the two if it lies on an edge.
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    for (Count f = 0; f < faces_.size(); ++f) {
      const auto [a, b] = steps(f);
      for (std::int64_t x = -b; x <= a; ++x) {
        for (std::int64_t y = 0; y <= a + b; ++y) {
          if (counts_to(f, weights(f, 3 * x + 1, 3 * y + 1, 3))) {
            result.push_back({name(f, x, y), name(f, x + 1, y), name(f, x, y + 1)});
          }
          if (counts_to(f, weights(f, 3 * x + 2, 3 * y + 2, 3))) {
            result.push_back({name(f, x + 1, y), name(f, x, y + 1), name(f, x + 1, y + 1)});
          }
        }
      }
    }
    return result;
  }

 private:
  /// The mirror image of the lattice has a and b exchanged.
  std::pair<std::int64_t, std::int64_t> steps(Count f) const {
    return f % 2 == 1 ? std::pair(b_, a_) : std::pair(a_, b_);
  }
  /// The face on the other side of the edge opposite corner k.
  Count face_across(Count f, std::size_t k) const {
    const auto& corners = faces_[f];
    for (Count g = 0; g < faces_.size(); ++g) {
      const auto& others = faces_[g];
      const auto has = [&](Count c) { return std::ranges::find(others, c) != others.end(); };
      if (g != f && has(corners[(k + 1) % 3]) && has(corners[(k + 2) % 3])) return g;
    }
    throw std::logic_error("every edge of the icosahedron lies in two faces");
  }
  /// The weights of the point (x + y zeta) / scale in face f, whose corners are a + b zeta,
  /// (a + b zeta) zeta and 0: the quotient by a + b zeta, times scale T; they sum up to that.
  /// |x|, |y| < 2^31 and T < 2^31, so nothing overflows.
  Weights weights(Count f, std::int64_t x, std::int64_t y, std::int64_t scale) const {
    const auto [a, b] = steps(f);
    const std::int64_t first = x * (a + b) + y * b;
    const std::int64_t second = y * a - x * b;
    return {first, second, scale * (a * a + a * b + b * b) - first - second};
  }
  bool counts_to(Count f, const Weights& w) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (w[k] < 0 || (w[k] == 0 && across_[f][k] < f)) return false;
    }
    return true;
  }
  /// The lattice point x + y zeta of face f, which may lie in the face next to it: unfolded, the
  /// far corner of that face is p + q - r for the edge (p, q) and f's corner r.
  Corner name(Count f, std::int64_t x, std::int64_t y) const {
    const Weights w = weights(f, x, y, 1);
    for (std::size_t k = 0; k < 3; ++k) {
      if (w[k] >= 0) continue;
      const Count g = across_[f][k];
      Weights unfolded{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& corners = faces_[f];
        const auto at = std::ranges::find(corners, faces_[g][i]);
        unfolded[i] =
            at == corners.end() ? -w[k] : w[static_cast<std::size_t>(at - corners.begin())] + w[k];
      }
      return corner_name(g, unfolded);
    }
    return corner_name(f, w);
  }
  /// The point with weights w in face f, the same name from every face that holds it: corners are
  /// (corner, 12, 0), points on an edge (low end, high end, weight of the high end), inner points
  /// (13 + face, w0, w1).
  Corner corner_name(Count f, const Weights& w) const {
    std::vector<std::pair<Count, Count>> support;  // corner, weight
    for (std::size_t i = 0; i < 3; ++i) {
      expect(w[i] >= 0, "a lattice triangle reaches no further than the next face");
      if (w[i] > 0) support.emplace_back(faces_[f][i], static_cast<Count>(w[i]));
    }
    std::sort(support.begin(), support.end());
    if (support.size() == 1) return {support[0].first, kNoCorner, 0};
    if (support.size() == 2) return {support[0].first, support[1].first, support[1].second};
    return {kNoCorner + 1 + f, static_cast<Count>(w[0]), static_cast<Count>(w[1])};
  }

  std::int64_t a_;
  std::int64_t b_;
  std::vector<Face> faces_;
  std::vector<std::array<Count, 3>> across_;  // the face across the edge opposite each corner
};

/// The pairs of triangles that have a side in common.
std::vector<std::pair<Count, Count>> neighbours(const std::vector<Triangle>& triangles) {
  std::vector<std::tuple<Corner, Corner, Count>> sides;  // low end, high end, triangle
  for (Count t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3]);
      sides.emplace_back(low, high, t);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::pair<Count, Count>> pairs;
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const auto& [low, high, triangle] = sides[i];
    const auto& [same_low, same_high, other] = sides[i + 1];
    expect(low == same_low && high == same_high,
           "every side of a closed triangulation lies in two triangles");
    pairs.emplace_back(triangle, other);
  }
  return pairs;
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

Graph nested_truncation(Count depth) {
  GraphBuilder builder(4 + 2 * depth, 6 + 3 * depth);
  builder.cycle(0, 3);
  Count inner = 3;
  std::array<Count, 3> around{0, 1, 2};
  for (Count d = 0; d < depth; ++d) {
    const Count second = 4 + 2 * d, third = second + 1;
    builder.edge(inner, around[0]);
    builder.edge(second, around[1]);
    builder.edge(inner, second);
    around = {around[2], inner, second};
    inner = third;
  }
  for (const Count v : around) builder.edge(inner, v);
  return builder.finish();
}

Graph iterated_truncation(Count n) {
  Graph graph = complete_graph(4);
  while (graph.num_vertices() < n) graph = truncated(graph);
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
    for (Count i = 0; i < around; ++i) {  // even ones look up, odd ones down
      builder.edge(r == 0 ? i : start - ring + 2 * i + 1, start + 2 * i);
    }
  }
  builder.cycle(bottom, around);
  for (Count i = 0; i < around; ++i) builder.edge(bottom - ring + 2 * i + 1, bottom + i);
  return builder.finish();
}

Graph goldberg_coxeter(Count a, Count b) {
  if (a < 1 || b > a || a > kMostSteps) {
    throw InputError(fmt::format("GC(a, b) takes a from 1 to {} and b up to a, not {} and {}",
                                 kMostSteps, a, b));
  }
  const std::vector<Triangle> triangles = GeodesicSphere(a, b).triangles();
  GraphBuilder builder(triangles.size(), 3 * triangles.size() / 2);
  for (const auto& [triangle, other] : neighbours(triangles)) builder.edge(triangle, other);
  return builder.finish();
}

}  // namespace ar3d
