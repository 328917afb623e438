#pragma once

// Compact modes of Theorem 1: any parity class for each vertex instead of even coordinates, and
// gaps only where an apex would fall on a turn. Always right; small in practice, but without a
// proved box of their own.

#include <optional>

#include "ar3d/algorithms/diamond/placement.h"

namespace ar3d::diamond {

/// The parity classes p(v) = X(v) mod 2 = Y(v) mod 2 along the green order, by rank.
enum class ParityPattern {
  alternating,  ///< 0 1 0 1: X takes neighbouring lines, so its range is n - 1
  pairs,        ///< 0 0 1 1: no two vertices two apart have |dX| = 2; good with many triangles
};

struct ParityPlacement {
  Placement placement;
  std::int64_t hits = 0;  ///< lines skipped because an apex would have fallen on a turn
};

/// @return nothing if the Y range passes 16n/3, which would put the drawing's x- or y-extent beyond
/// it. Cost: O(n).
std::optional<ParityPlacement> place_by_parity(const Graph& graph, Items green, Items red,
                                               ParityPattern pattern);

/// @param parity  p(v) by vertex, 0 or 1.
std::optional<ParityPlacement> place_by_parity(const Graph& graph, Items green, Items red,
                                               const std::vector<std::uint8_t>& parity);

}  // namespace ar3d::diamond
