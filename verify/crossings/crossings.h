#pragma once

#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/crossings/segments.h"

namespace ar3d::verify {

// Each test names every pair of segments that meets, and every vertex on a segment, to `contacts`.

/// The oracle: every pair. O(S (S + n)) time, a box per segment.
void test_all_pairs(const Segments& segments, Contacts& contacts);

/// Cuts at the heights that no segment crosses, and searches each slab for near pairs. O((S + n)
/// log S) time where segments are short, at most quadratic (Lemma V.8); O(S + n) memory.
void test_by_slabs(const Segments& segments, Contacts& contacts);

}  // namespace ar3d::verify
