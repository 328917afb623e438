#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/crossings/segments.h"

namespace ar3d::verify {

/// A segment or a vertex.
struct DrawnItem {
  std::uint32_t number;
  bool is_vertex;
};

/// And its box.
struct BoxedItem {
  DrawnItem item;
  Box box;
};

inline bool apart(const Box& a, const Box& b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y ||
         a.high.z < b.low.z || b.high.z < a.low.z;
}

/// All segments and then all vertices of the drawing.
std::vector<BoxedItem> boxed_items(const Segments& segments);
/// A segment with a segment or vertex that it may meet; the check of the vertices sees two
/// vertices.
void examine_pair(DrawnItem a, DrawnItem b, Contacts& contacts);

// Each test names every pair of segments that meets, and every vertex on a segment, to `contacts`.

/// The oracle: every pair. O(S (S + n)) time, a box per segment.
void test_all_pairs(const Segments& segments, Contacts& contacts);

/// Cuts at the heights that no segment crosses, and searches each slab for near pairs. O((S + n) log S) time where segments are short, at most quadratic (Lemma V.8); O(S + n)
/// memory.
void test_by_slabs(const Segments& segments, Contacts& contacts);

}  // namespace ar3d::verify
