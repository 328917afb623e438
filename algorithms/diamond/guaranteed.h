#pragma once

// Theorem 1, guaranteed mode: even coordinates and few gaps, hence the box 16n/3 x 16n/3 x 8n.
// Paper, Section 2.

#include "ar3d/algorithms/diamond/placement.h"

namespace ar3d::diamond {

/// Where the width comes from: the x- and the y-extent are at most 4n + 2H, the z-extent at most 6n
/// + 3H - 4 (n >= 2), with H = green_gaps + bumps + offsets <= m_green + rho + 2.
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

struct GuaranteedPlacement {
  Placement placement;  ///< all coordinates even
  GapCount gaps;
};

/// @param green,red  the items of a two-colouring of the graph's edges. Cost: O(n).
GuaranteedPlacement place_guaranteed(const Graph& graph, Items green, Items red);

}  // namespace ar3d::diamond
