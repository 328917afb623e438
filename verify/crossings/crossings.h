#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/crossings/segments.h"

namespace ar3d::verify {

/// A segment or a vertex, with its box.
struct DrawnItem {
  std::uint32_t number;
  bool is_vertex;
  Box box;
};

/// All segments and then all vertices of the drawing.
std::vector<DrawnItem> drawn_items(const Segments& segments);
/// Compares a segment with a segment or vertex that it may meet, unless their boxes are apart; the
/// check of the vertices sees two vertices.
void examine_pair(const DrawnItem& a, const DrawnItem& b, Contacts& contacts);

// Each test names every pair of segments that meets, and every vertex on a segment, to `contacts`.

/// The oracle: every pair. O(S (S + n)) time, a box per segment.
void test_all_pairs(const Segments& segments, Contacts& contacts);

/// Cuts at the heights that no segment crosses, and searches each slab for near pairs. O((S + n)
/// log S) time where segments are short, at most quadratic (Lemma V.8); O(S + n) memory.
void test_by_slabs(const Segments& segments, Contacts& contacts);

}  // namespace ar3d::verify
