#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/algorithms/grid/defect_paths.h"

namespace ar3d::grid {

/// The slot's number k in (I5): colour 0 counts heights upwards, colour 1 downwards.
inline std::int64_t slot_number(const ColourDefect& defect, const HeightSlot& slot) {
  return defect.label_x == 0 ? -slot.low : slot.low + 1;
}

struct ThirdColourResult {
  /// A defect of a circle of ends y that depend on one another; none if all is well.
  std::vector<std::size_t> circle;
  std::int64_t blocks = 0;  ///< of 64 numbers looked at
};

/// X_2 of one component whose other numbers are known: every edge of colour 2 gets about the first
/// number that makes both sums new and far from their neighbours' sums, (I1) and (I2). Then the
/// label-2 ends y of the defects get theirs, below X_2(x) if label_x = 0 and above it if label_x =
/// 1, far enough for the slot.
ThirdColourResult number_third_colour(std::span<const Ports> ports, PlaceRange part,
                                      std::span<const ColourDefect> defects,
                                      std::span<const HeightSlot> slots, std::span<PlaneNumbers> x);

}  // namespace ar3d::grid
