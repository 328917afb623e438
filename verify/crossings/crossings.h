#pragma once

#include "ar3d/verify/checks/contacts.h"
#include "ar3d/verify/checks/directions.h"
#include "ar3d/verify/crossings/segments.h"

namespace ar3d::verify {

// Each test names every pair of segments that meets, and every vertex on a segment, to `contacts`.

/// The oracle: every pair. O(S (S + n)) time, a box per segment.
void test_all_pairs(const Segments& segments, Contacts& contacts);

/// Lines and plane families, for few directions: O(k (S + n) log S + meetings) time for k
/// directions.
void test_by_plane_sweep(const Segments& segments, const DirectionClasses& classes,
                         Contacts& contacts);

/// For drawings with many directions whose long segments are vertical and whose others are low:
/// slabs that nothing crosses, in them vertical segments in columns indexed by x and y, the others
/// in a plane sweep upwards. O((S + n) log S + C) time, where C counts the columns and the
/// segments, not vertical and at a common height, that are compared; O(S + n) memory. In the worst
/// case C is quadratic.
void test_by_slabs(const Segments& segments, Contacts& contacts);

}  // namespace ar3d::verify
