#pragma once

#include "ar3d/verify/checks/contacts.h"
#include "ar3d/verify/checks/directions.h"

namespace ar3d::verify {

/// Names every pair of collinear segments that meet and every vertex on a segment.
/// @param bound  no coordinate is larger in absolute value.
/// Per direction d: a line along d is known by two independent functionals that vanish along d; the
/// segments of this direction and all vertices are sorted by line and along it, and each is
/// compared with those that begin before it ends. O((S + k n) log(S + n) + meetings) time for k
/// directions; about 48 bytes for each segment of one direction and each vertex.
void crossings_on_lines(const Segments& segments, const DirectionClasses& classes,
                        std::int64_t bound, Contacts& contacts);

}  // namespace ar3d::verify
