// Cuts at the heights that no segment crosses, and each slab by
// halving space (Steps V.12 to V.14), as the proof by counting does with slanted segments.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/verify/crossings/crossings.h"
#include "ar3d/verify/crossings/near_pairs.h"

namespace ar3d::verify {
namespace {

void examine_slab(const Segments& segments, std::span<const DrawnItem> items, Contacts& contacts) {
  const auto at = [&](std::uint32_t i) {
    if (items[i].is_vertex) return SegmentInSpace{items[i].box.low, {}};
    return SegmentInSpace{segments.from(items[i].number), segments.direction(items[i].number)};
  };
  const auto visit = [&](std::uint32_t i, std::uint32_t j) {
    examine_pair(items[i], items[j], contacts);
    return !contacts.done();
  };
  constexpr std::size_t kFew = 48;  // items in a cell
  contacts.spend(for_each_near_pair(static_cast<std::uint32_t>(items.size()), at, visit, kFew,
                                    contacts.comparisons_left()));
}

}  // namespace

void test_by_slabs(const Segments& segments, Contacts& contacts) {
  std::vector<DrawnItem> items = drawn_items(segments);
  std::sort(items.begin(), items.end(),
            [](const DrawnItem& a, const DrawnItem& b) { return a.box.low.z < b.box.low.z; });
  for (std::size_t begin = 0; begin < items.size() && !contacts.done();) {
    std::int64_t highest = items[begin].box.high.z;
    std::size_t end = begin + 1;
    for (; end < items.size() && items[end].box.low.z <= highest; ++end) {
      highest = std::max(highest, items[end].box.high.z);
    }
    examine_slab(segments, std::span(items).subspan(begin, end - begin), contacts);
    begin = end;
  }
}

}  // namespace ar3d::verify
