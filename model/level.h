#pragma once

#include <cstdint>
#include <string_view>

#include "ar3d/model/drawing.h"

namespace ar3d {

/// How much of a drawing is stored while it is measured and judged. All that is told of it is the
/// same at every level, bit for bit; time and memory differ.
enum class Level : std::uint8_t {
  extents,    ///< what the algorithm keeps: a polyline is computed when it is read, and dropped
  positions,  ///< also an array of all positions in 64-bit integers: 24 bytes per vertex
  full        ///< also an array of all bends: 24 bytes per bend and 8 per edge
};
/// "extents", "positions", "full".
const char* to_string(Level level);
/// @throws InputError naming the text and the levels if it is none.
Level parse_level(std::string_view text);

/// The same drawing with as much of it stored as the level says. O(n + bends) time.
Drawing at_level(Drawing drawing, Level level);

}  // namespace ar3d
