#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/verify/counting/columns.h"
#include "ar3d/verify/counting/plane_records.h"

namespace ar3d::verify {

/// The meetings of slanted segments with each other: upwards, each is compared with those begun
/// before it that reach its lower end (Step V.11); if that takes more than `patience` comparisons
/// per segment, by halving space (Steps V.12 to V.14). Nothing if there are many more meetings than
/// a right drawing has.
std::optional<MeetingCounts> meetings_of_slanted(const std::vector<SlantedSegment>& segments,
                                                 std::size_t patience);

}  // namespace ar3d::verify
