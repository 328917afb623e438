#include <algorithm>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/verify/crossings.h"

namespace ar3d::verify {
namespace {

bool apart(std::int64_t low_a, std::int64_t high_a, std::int64_t low_b, std::int64_t high_b) {
  return high_a < low_b || high_b < low_a;
}

bool apart(const Box& a, const Box& b) {
  return apart(a.low.x, a.high.x, b.low.x, b.high.x) ||
         apart(a.low.y, a.high.y, b.low.y, b.high.y) || apart(a.low.z, a.high.z, b.low.z, b.high.z);
}

Box box_of(Point p, Point q) {
  return {{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
          {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}};
}

}  // namespace

void test_all_pairs(const Segments& segments, Contacts& contacts) {
  std::vector<Box> boxes;
  boxes.reserve(segments.size());
  for (SegmentId s = 0; s < segments.size(); ++s) {
    boxes.push_back(box_of(segments.from(s), segments.to(s)));
  }
  const Drawing& drawing = segments.drawing();
  for (SegmentId a = 0; a < segments.size() && !contacts.done(); ++a) {
    for (SegmentId b = a + 1; b < segments.size(); ++b) {
      if (!apart(boxes[a], boxes[b])) contacts.examine(a, b);
    }
    for (Vertex v = 0; v < drawing.num_vertices(); ++v) {
      const Point p = drawing.vertex(v);
      if (!apart(boxes[a], Box{p, p})) contacts.examine_vertex(v, a);
    }
  }
}

}  // namespace ar3d::verify
