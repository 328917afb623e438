#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/verify/counting/columns.h"
#include "ar3d/verify/counting/plane_records.h"

namespace ar3d::verify {

/// The meetings of slanted segments with each other (Step V.11): upwards, each is compared with
/// those begun before it that reach its lower end. Nothing if that takes more than `patience`
/// comparisons per segment.
std::optional<MeetingCounts> meetings_of_slanted(const std::vector<SlantedSegment>& segments,
                                                 std::size_t patience);

}  // namespace ar3d::verify
