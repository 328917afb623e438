#pragma once

#include "ar3d/verify/contacts.h"
#include "ar3d/verify/directions.h"
#include "ar3d/verify/segments.h"

namespace ar3d::verify {

// Each test names every pair of segments that meets, and every vertex on a segment, to `contacts`.

/// The oracle: every pair. O(S (S + n)) time, a box a segment.
void test_all_pairs(const Segments& segments, Contacts& contacts);

/// Lines and plane families, for few directions: O(k (S + n) log S + meetings) time for k
/// directions.
void test_by_sweep(const Segments& segments, const DirectionClasses& classes, Contacts& contacts);

}  // namespace ar3d::verify
