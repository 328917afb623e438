#pragma once

// Theorem 1, guaranteed mode: even coordinates and few gaps, hence the box 16n/3 x 16n/3 x 8n.
// Paper, Section 2. Coordinates of cycles.cpp are x = X/2 and y = Y/2.

#include <utility>

#include "ar3d/algorithms/diamond/placement.h"

namespace ar3d::diamond {

/// Items in an order and direction such that the last vertex of one and the first vertex of the
/// next are not adjacent, with at most one exception if n >= 4, and none if there are at least 6
/// items; an exception is a bad boundary. Proof: Lemma 1.3. Cost: O(n).
Arrangement order_items(const Graph& graph, const Items& items);

/// bad[i] (i >= 1): items i-1 and i, laid side by side, would put two adjacent vertices on
/// neighbouring lines.
std::vector<bool> bad_boundaries(const Graph& graph, const Items& items);

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

struct RedCycles {
  /// By natural red item: by how many lines the first vertex of a red cycle is moved down, and the
  /// last one up.
  std::vector<std::pair<std::uint8_t, std::uint8_t>> bumps;
  std::vector<std::uint32_t> turned;  ///< likewise: by how many vertices its first one moved on
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

/// Holds where the width comes from: the x- and the y-extent are at most 4n + 2H, the z-extent at
/// most 6n + 3H - 4 (n >= 2), with H = green_gaps + bumps + offsets <= m_green + rho + 2.
struct GapCount {
  std::int64_t m_green = 0;     ///< green cycles
  std::int64_t m_red = 0;       ///< red cycles
  std::int64_t contained = 0;   ///< green cycles inside one red item
  std::int64_t rho = 0;         ///< red cycles that contain a green cycle
  std::int64_t green_gaps = 0;  ///< D: gaps at bad boundaries of the green order
  std::int64_t red_gaps =
      0;  ///< C: bad boundaries of the red order (their gaps are among the offsets)
  std::int64_t bumps = 0;    ///< lines by which ends of containing red cycles are moved out
  std::int64_t offsets = 0;  ///< free lines before red items
  std::int64_t H() const { return green_gaps + bumps + offsets; }
};

/// @param green,red  the items of a two-colouring of the graph's edges. Cost: O(n).
/// @return a placement with all coordinates even, and its gaps.
std::pair<Placement, GapCount> place_guaranteed(const Graph& graph, Items green, Items red);

}  // namespace ar3d::diamond
