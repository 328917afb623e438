#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ar3d/model/lattice.h"

namespace ar3d::two_bend_109 {

/// Squared length 2x^2 + 6y^2 + z^2: the cube grid seen along (1, 1, 1), times sqrt(3). Here a
/// regular tetrahedron may stand exactly on the z-axis: (0, 0, 3), (2, 0, -1), (-1, 1, -1),
/// (-1, -1, -1).
inline constexpr Lattice kAxisLattice{{{{2, 0, 0}, {0, 6, 0}, {0, 0, 1}}}, 1};

/// Says how a vertex stands: which of its edges go where.
enum class Stance : std::uint8_t {
  middle,          ///< at most two edges up, at most two down
  three_down,      ///< three edges down, one of them to the right, two to the left; at most one up
  chain,           ///< on a cycle, beside its right and its left neighbour
  corner,          ///< on a cycle, beside one neighbour to the right and one at larger y
  triangle_right,  ///< the right corner of a triangle; the others at the angles 150 and 210 degrees
  triangle_upper,  ///< its corner with the largest y; the others at -30 and -90 degrees
};

/// The four first segments of a vertex, of a regular tetrahedron in kAxisLattice.
struct Stubs {
  /// middle: up, up, down, down. three_down: up, right, left at larger y, left at smaller y. On a
  /// cycle: two for the edges that leave it, the steeper one first if both go up or both down, then
  /// one for each neighbour on it, in the order in which the stance names them.
  std::array<Vector, 4> ends;
  /// Edges up (and down) from here may lean by one part in so many.
  std::int64_t up_slope = 0;
  std::int64_t down_slope = 0;
};

/// The largest component of any stub along each axis; of those on cycles of four and more vertices.
inline constexpr std::int64_t kStubX = 20;
inline constexpr std::int64_t kStubY = 11;
inline constexpr std::int64_t kStubZ = 21;
inline constexpr std::int64_t kCycleStubZ = 13;

/// @param downs  edges to earlier parts; on a cycle 0, 1 or 2, and with 1 the first stub goes up
/// and the second one down.
Stubs stubs_of(Stance stance, unsigned downs);

/// The mirror image in x, in y.
Stubs mirrored(Stubs stubs, bool in_x, bool in_y);

/// Numbers all that stubs_of() and mirrored() may give: a vertex keeps one byte.
inline std::uint8_t number_of_stubs(Stance stance, std::size_t downs, bool in_x = false,
                                    bool in_y = false) {
  return static_cast<std::uint8_t>(16 * static_cast<std::size_t>(stance) + 4 * downs +
                                   (in_x ? 2 : 0) + (in_y ? 1 : 0));
}
const Stubs& stubs_by_number(std::uint8_t number);

}  // namespace ar3d::two_bend_109
