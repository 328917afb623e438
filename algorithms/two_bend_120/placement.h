#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/algorithms/two_bend_120/numbering.h"
#include "ar3d/model/lattice.h"

namespace ar3d::two_bend_120 {

/// Directions are ordered pairs ij of four letters, here 0 to 3 (the page says 1 to 4): e_i - e_j.
struct Direction {
  int plus = 0;
  int minus = 0;
  friend bool operator==(const Direction&, const Direction&) = default;
};
inline constexpr Direction operator-(Direction d) { return {d.minus, d.plus}; }

/// A vector of four numbers with sum 0, of which (x, y, z) are the first plus each of the others.
using FourVector = std::array<std::int64_t, 4>;

inline constexpr Vector to_grid(const FourVector& v) {
  return {v[0] + v[1], v[0] + v[2], v[0] + v[3]};
}
inline constexpr FourVector to_four(Direction d) {
  FourVector v{};
  v[static_cast<std::size_t>(d.plus)] += 1;
  v[static_cast<std::size_t>(d.minus)] -= 1;
  return v;
}

/// A word of Lemma F.1: lengths of at most three segments, the first along `first`, the last along
/// `last`, that sum to `sum`; nothing if there is none. If it is planar, the middle one has length
/// 1; if it is straight, the first two have length 0.
using EdgeWord = std::pair<std::array<Direction, 3>, std::array<std::int64_t, 3>>;
EdgeWord find_word(Direction first, Direction last, const FourVector& sum);

/// How far the drawing of a vertex may reach along its three edges, by slot (Lemma F.8).
using Reach = std::vector<std::array<std::uint32_t, 3>>;

/// The places of the vertices, and the directions in which their edges leave them, by slot.
struct ForkPlaces {
  std::vector<FourVector> at;
  std::vector<std::array<Direction, 3>> stars;
};

/// Step F.5: stars, a, b and heights. Cost: O(n).
/// @param reach  by index in the numbering, as the result; all 1 for vertices that are drawn as points.
ForkPlaces place(const ForkOrder& numbering, const Orders& orders, const Reach& reach);

/// A finished drawing with at most two bends per edge, along face diagonals.
struct SmallCore {
  std::vector<Point> at;
  std::vector<std::tuple<Vertex, Vertex, std::vector<Point>>>
      lines;  ///< bends from first to second
};

/// Lemma F.7: the drawing of K4, K3,3, the Wagner graph or the Petersen graph, which have no
/// numbering, its vertices and lines in the graph's names; nothing of another connected graph. O(1):
/// at most ten vertices.
std::optional<SmallCore> small_core_of(const CubicGraph& graph);

}  // namespace ar3d::two_bend_120
