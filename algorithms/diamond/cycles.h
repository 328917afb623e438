#pragma once

// Steps 1.3 and 1.5: where the cycles are closed. Coordinates here are x =
// X/2 and y = Y/2.

#include "ar3d/algorithms/diamond/placement.h"

namespace ar3d::diamond {

/// The closing edge of a green cycle, and the red item that holds the whole cycle, or kNone.
struct GreenClosing {
  Vertex u = 0;
  Vertex w = 0;
  std::uint32_t contained_in = kNone;
};

/// Step 1.3. Rotates every green cycle. A closing edge between two red items is free to change its
/// length with their offset; one inside a red item R has |rp(u) - rp(w)| != k - 1 = |x(u) - x(w)|
/// for the natural ranks rp in R. One entry a green cycle. Cost: O(n).
std::vector<GreenClosing> close_green_cycles(Items& green, const Whereabouts& natural_red);

/// The first vertex of a red cycle is moved down by `first` lines and the last one up by `last`
/// lines.
struct Bump {
  std::uint8_t first = 0;
  std::uint8_t last = 0;
};

struct RedCycles {
  std::vector<Bump> bumps;            ///< by natural red item
  std::vector<std::uint32_t> turned;  ///< likewise: by how many places its first vertex moved on
  std::int64_t contained = 0;         ///< green cycles inside one red item
  std::int64_t rho = 0;               ///< red cycles that contain a green cycle
  std::int64_t lines = 0;             ///< sum of all bumps
};

/// Step 1.5. Rotates or bumps every red cycle, so that inside every red item all edges but the
/// green closings to other items have |dx| != |dy|. All x are final. Cost: O(n).
RedCycles settle_red_cycles(Items& red, const std::vector<GreenClosing>& closings,
                            const PlanePoints& at, const Whereabouts& natural_red);

inline std::int32_t x_distance(const PlanePoints& at, Vertex u, Vertex v) {
  return std::abs(at[u].X - at[v].X);
}

}  // namespace ar3d::diamond
