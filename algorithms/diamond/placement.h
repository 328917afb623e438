#pragma once

// The plane picture of Theorem 1: what every mode has to produce, and what is needed of it.

#include <array>
#include <cstdint>
#include <cstdlib>

#include "ar3d/algorithms/diamond/items.h"

namespace ar3d::diamond {

/// Largest n drawn. In every mode a coordinate X or Y is at most 16n/3 + 14 < 2^30, and so are
/// tracks; sums and differences of two of them therefore fit 32 bits, and a track with its colour
/// bit too.
inline constexpr Vertex kMaxVertices = 1u << 27;

/// The plane coordinates of one vertex; in space it is (X - Y, X + Y, 0).
struct PlanePoint {
  std::int32_t X = 0;
  std::int32_t Y = 0;
};

/// By vertex; new elements are not set.
using PlanePoints = UnwrittenVector<PlanePoint>;

/// Plane coordinates with everything that the routes need. Invariants:
///  - all X distinct and all Y distinct, X(v) + Y(v) even: then every path length is even, and
///  apexes are integer points;
///  - X increases along the green order, Y along the red order: then no two plane paths of one
///  colour meet;
///  - (C1) |dX| != |dY| for every edge: the apex of an edge drawn as U is never one of its turns;
///  - (C2) every odd cycle has a path edge that can be drawn as Z (z_distance > 0).
struct Placement {
  Items green;
  Items red;
  PlanePoints at;
};

/// Distance of a Z's track from the edge's first end, or 0 if no track works: with a and b =
/// |across| - a the distances from the ends, the apex is on a turn iff |a - b| = |along|.
/// @param along   distance of the ends in the coordinate that orders the colour (green: |dX|)
/// @param across  distance in the other coordinate (green: |dY|)
/// a = 1 fails only if | |across| - 2 | = |along|, and then a = 2 works if it leaves b >= 1 (the
/// case that the paper missed is across = 4, along = 2). So it is 0 only for across = 1 and for
/// (across, along) = (3, 1).
inline std::int32_t z_distance(std::int32_t along, std::int32_t across) {
  along = std::abs(along);
  across = std::abs(across);
  if (across < 2) return 0;
  if (std::abs(across - 2) != along) return 1;
  return across > 2 && std::abs(across - 4) != along ? 2 : 0;
}

bool adjacent(const Graph& graph, Vertex u, Vertex v);

/// 3 * x-extent and 3 * y-extent <= 16n, z-extent <= 8n.
bool fits_theorem_box(const std::array<std::int64_t, 3>& extents, std::uint64_t n);

/// Checks all four invariants; O(n + m).
bool keeps_invariants(const Graph& graph, const Placement& placement);

}  // namespace ar3d::diamond
