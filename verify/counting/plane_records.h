#pragma once

#include <cstdint>

namespace ar3d::verify {

/// What is counted in the planes and on the lines of a drawing.
struct MeetingCounts {
  std::uint64_t crossing = 0;  ///< pairs of segments, not parallel, that meet
  std::uint64_t touching = 0;  ///< pairs of collinear segments with one point in common; too few
                               ///< only if a point on an end was counted, too
  bool overlap = false;        ///< collinear segments with more in common were seen
  MeetingCounts& operator+=(const MeetingCounts& other);
};

/// A segment in a plane of a family, or rather in a bucket of planes: it stays at `at` across its
/// own direction and runs from low to high across the other one.
struct PlaneRecord {
  std::uint32_t plane;  ///< equal for segments of one plane only
  std::int32_t at;
  std::int32_t low;
  std::int32_t high;
};

/// Which lines are looked at besides the planes.
struct LinesToCount {
  bool rows = false;
  bool columns = false;
};

}  // namespace ar3d::verify
