#pragma once

#include "ar3d/verify/contacts.h"
#include "ar3d/verify/segments.h"

namespace ar3d::verify {

// Each test names every pair of segments that meets, and every vertex on a segment, to `contacts`.

/// The oracle: every pair. O(S (S + n)) time, a box a segment.
void test_all_pairs(const Segments& segments, Contacts& contacts);

}  // namespace ar3d::verify
