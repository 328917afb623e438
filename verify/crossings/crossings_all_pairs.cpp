// Compares every pair. It is the oracle for the quick tests, so it stays plain.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/verify/crossings/crossings.h"

namespace ar3d::verify {
namespace {

bool apart(const Box& a, const Box& b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y ||
         a.high.z < b.low.z || b.high.z < a.low.z;
}

}  // namespace

std::vector<DrawnItem> drawn_items(const Segments& segments) {
  const Drawing& drawing = segments.drawing();
  std::vector<DrawnItem> items;
  items.reserve(segments.size() + drawing.num_vertices());
  for (SegmentId s = 0; s < segments.size(); ++s) {
    GrowingBox box;
    box.add(segments.from(s));
    box.add(segments.to(s));
    items.push_back({s, false, box.box()});
  }
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) {
    items.push_back({v, true, {drawing.vertex(v), drawing.vertex(v)}});
  }
  return items;
}

void examine_pair(const DrawnItem& a, const DrawnItem& b, Contacts& contacts) {
  if ((a.is_vertex && b.is_vertex) || apart(a.box, b.box)) return;
  if (a.is_vertex) {
    contacts.examine_vertex(a.number, b.number);
  } else if (b.is_vertex) {
    contacts.examine_vertex(b.number, a.number);
  } else {
    contacts.examine(a.number, b.number);
  }
}

/// Every pair whose boxes meet: the boxes are taken by least x, and all others that begin before
/// one ends are looked at. A vertex is a box, too. Quadratic, but most segments of a tall drawing
/// are narrow.
void test_all_pairs(const Segments& segments, Contacts& contacts) {
  std::vector<DrawnItem> items = drawn_items(segments);
  std::sort(items.begin(), items.end(),
            [](const DrawnItem& a, const DrawnItem& b) { return a.box.low.x < b.box.low.x; });
  for (std::size_t i = 0; i < items.size() && !contacts.done(); ++i) {
    for (std::size_t j = i + 1; j < items.size(); ++j) {
      if (items[j].box.low.x > items[i].box.high.x) break;
      examine_pair(items[i], items[j], contacts);
    }
  }
}

}  // namespace ar3d::verify
