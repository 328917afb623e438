// The two crossing tests. One compares every pair: it is the oracle, so it stays plain. The other
// halves space (Steps V.12 to V.14), as the proof by counting does with slanted segments.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "ar3d/verify/crossings/contacts.h"
#include "ar3d/verify/crossings/near_pairs.h"

namespace ar3d::verify {
namespace {

/// A segment or a vertex, with its box.
struct DrawnItem {
  std::uint32_t number;
  bool is_vertex;
  Box box;
};

/// All segments and then all vertices of the drawing.
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

/// Compares a segment with a segment or vertex that it may meet, unless their boxes are apart; the
/// check of the vertices sees two vertices.
void examine_pair(const DrawnItem& a, const DrawnItem& b, Contacts& contacts) {
  if ((a.is_vertex && b.is_vertex) || are_apart(a.box, b.box)) return;
  if (a.is_vertex) {
    contacts.examine_vertex(a.number, b.number);
  } else if (b.is_vertex) {
    contacts.examine_vertex(b.number, a.number);
  } else {
    contacts.examine(a.number, b.number);
  }
}

}  // namespace

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

void test_by_halving(const Segments& segments, Contacts& contacts) {
  const std::vector<DrawnItem> items = drawn_items(segments);
  const auto at = [&](std::uint32_t i) {
    const std::uint32_t number = items[i].number;
    if (items[i].is_vertex) return SegmentInSpace{items[i].box.low, {}};
    return SegmentInSpace{segments.from(number), segments.direction(number)};
  };
  const auto visit = [&](std::uint32_t i, std::uint32_t j) {
    examine_pair(items[i], items[j], contacts);
    return !contacts.done();
  };
  constexpr std::size_t kFew = 48;  // items in a cell
  contacts.spend(for_each_near_pair(static_cast<std::uint32_t>(items.size()), at, visit, kFew,
                                    contacts.comparisons_left(), contacts.compares));
}

}  // namespace ar3d::verify
