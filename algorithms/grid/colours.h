#pragma once

#include <cstdint>

namespace ar3d::grid {

/// One of the three edge colours 0, 1, 2. Colour c stands for the direction e_{c+1} - e_{c+2} in
/// the four coordinates (x_0, x_1, x_2, x_3) of sum 0; the half-edge labelled c leaves its vertex
/// in this direction.
using Colour = unsigned;

inline constexpr Colour kColours = 3;
inline constexpr Colour kNoColour = 3;

inline constexpr Colour next(Colour c) { return c == 2 ? 0 : c + 1; }      // c + 1 mod 3
inline constexpr Colour previous(Colour c) { return c == 0 ? 2 : c - 1; }  // c - 1 mod 3

/// A set of colours; bit c stands for colour c.
using ColourSet = unsigned;
inline constexpr ColourSet kAllColours = 7;
inline constexpr ColourSet only(Colour c) { return 1u << c; }
inline constexpr bool contains(ColourSet set, Colour c) { return ((set >> c) & 1u) != 0; }
/// The smallest colour of a non-empty set.
inline constexpr Colour first_of(ColourSet set) {
  return (set & 1u) != 0 ? 0 : (set & 2u) != 0 ? 1 : 2;
}

}  // namespace ar3d::grid
