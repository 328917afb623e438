#pragma once

#include "ar3d/verify/checks/contacts.h"
#include "ar3d/verify/checks/directions.h"

namespace ar3d::verify {

/// Names every pair of segments of different directions that meet.
/// @param bound  no coordinate is larger in absolute value.
/// Two such segments lie in a common plane that contains both directions. So for each pair of
/// directions the segments are grouped by their plane, and within a plane the two directions serve
/// as axes: there the test is that of horizontal against vertical segments. O(k S log S + meetings)
/// time for k directions; 72 bytes for each segment of two directions, and a plane's segments.
void crossings_in_planes(const Segments& segments, const DirectionClasses& classes,
                         std::int64_t bound, Contacts& contacts);

}  // namespace ar3d::verify
