#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/algorithms/grid/labels.h"

namespace ar3d::grid {

/// Holds where the three labelled half-edges of a vertex lead; one cache line holds four.
struct alignas(16) Ports {
  std::array<Index, kColours> to{kNoIndex, kNoIndex, kNoIndex};  ///< by label; kNoIndex: none
  std::uint32_t has_defect = 0;  ///< 1 if the labels of a half-edge to an earlier vertex differ
};

/// An edge whose two labels differ: label_x at x, label_y at y. One of them is 2 and belongs to y,
/// unless the labels are 0 and 1.
struct ColourDefect {
  Index x = 0;
  Index y = 0;
  EdgeId edge = 0;
  Colour label_x = 0;
  Colour label_y = 0;
};

/// Labels of all half-edges, with few defects.
/// Invariant: the labels at a vertex differ; the two labels of an edge are equal except on the edges
/// in `defects`. A component has at most one defect with labels 0 and 1.
struct Colouring {
  UnwrittenVector<Ports> ports;       // by index
  std::vector<ColourDefect> defects;  // component by component, in processing order
  std::uint64_t chain_steps = 0;      ///< edges of Kempe chains followed
};

/// Labels greedily in processing order and swaps Kempe chains where two earlier neighbours offer
/// the same label.
/// @param longest_chain  edges of the longest chain that is followed; 0: none.
/// Cost: O(n) and at most kStepsPerVertex chain steps per vertex on average.
Colouring colour_half_edges(const ProcessingOrder& order, std::span<const PlacedRow> neighbours,
                            std::uint64_t longest_chain);

/// All chains together take at most this many steps per vertex, so the time is linear on every
/// input.
inline constexpr std::uint64_t kStepsPerVertex = 100;

}  // namespace ar3d::grid
