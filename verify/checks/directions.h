#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/verify/crossings/segments.h"

namespace ar3d::verify {

/// The plane sweep's limits: so many directions, and primitive components below this in absolute
/// value.
inline constexpr std::size_t kMaxDirections = 16;
inline constexpr std::int64_t kMaxDirectionComponent = std::int64_t{1} << 20;

/// The directions that a drawing really has, up to sign, and which of them each segment has.
struct DirectionClasses {
  std::vector<Vector> directions;  ///< primitive, pairwise not parallel
  std::vector<std::uint8_t> of;    ///< one entry per segment
};

/// Nothing if the drawing passes the plane sweep's limits. O(S) time for a bounded number of
/// directions.
std::optional<DirectionClasses> few_directions(const Segments& segments);

}  // namespace ar3d::verify
