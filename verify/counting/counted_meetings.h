#pragma once

#include <cstdint>

#include "ar3d/verify/counting/plane_records.h"

namespace ar3d::verify {

/// What must be equal if nothing meets that must not (Lemma V.1).
struct CountedMeetings {
  std::uint64_t crossing_neighbours = 0;  ///< A: neighbours that are not parallel
  std::uint64_t touching_neighbours = 0;  ///< B: neighbours that are parallel
  MeetingCounts found;                    ///< M, T, and whether an overlap was seen
  bool agree() const {
    return !found.overlap && found.crossing == crossing_neighbours &&
           found.touching == touching_neighbours;
  }
};

}  // namespace ar3d::verify
