#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "ar3d/verify/crossings/crossings.h"
#include "ar3d/verify/crossings/near_pairs.h"
#include "ar3d/verify/crossings/slab_columns.h"

namespace ar3d::verify {
namespace {

/// By their lower ends; segments before the vertices in which they may begin.
std::vector<BoxedItem> items_upwards(const Segments& segments) {
  std::vector<BoxedItem> items = boxed_items(segments);
  std::sort(items.begin(), items.end(), [](const BoxedItem& a, const BoxedItem& b) {
    return std::tie(a.box.low.z, a.is_vertex, a.number) <
           std::tie(b.box.low.z, b.is_vertex, b.number);
  });
  return items;
}

/// Of two items at a common height.
bool boxes_meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Segments that are not vertical against each other and against vertices: upwards, each against
/// those begun before it that reach its lower end; if there are many, by halving space.
class SlantedSegments {
 public:
  SlantedSegments(const Segments& segments, Contacts& contacts)
      : segments_(segments), contacts_(contacts) {}

  /// The items of a slab, upwards.
  void examine(std::span<const BoxedItem> items) {
    if (!examine_upwards(items)) examine_by_halving(items);
  }

 private:
  /// False if that takes too many comparisons.
  bool examine_upwards(std::span<const BoxedItem> items) {
    std::uint64_t left = kPatience * items.size();
    active_.clear();
    for (const BoxedItem& item : items) {
      if (contacts_.done()) return true;
      if (active_.size() > left) return false;
      left -= active_.size();
      add(item);
    }
    return true;
  }

  void add(const BoxedItem& item) {
    std::erase_if(active_, [&](const BoxedItem& old) { return old.box.high.z < item.box.low.z; });
    for (const BoxedItem& old : active_) {
      if (contacts_.done()) return;
      if (boxes_meet(old.box, item.box)) examine_pair(item, old, contacts_);
    }
    if (!item.is_vertex) active_.push_back(item);
  }

  void examine_by_halving(std::span<const BoxedItem> items) {
    const auto at = [&](std::uint32_t i) {
      const BoxedItem& item = items[i];
      if (item.is_vertex) return SegmentInSpace{segments_.drawing().vertex(item.number), {}};
      return SegmentInSpace{segments_.from(item.number), segments_.direction(item.number)};
    };
    const auto visit = [&](std::uint32_t i, std::uint32_t j) {
      examine_pair(items[i], items[j], contacts_);
      return !contacts_.done();
    };
    contacts_.spend(for_each_near_pair(static_cast<std::uint32_t>(items.size()), at, visit, kFew,
                                       contacts_.comparisons_left()));
  }

  static constexpr std::uint64_t kPatience = 200;  ///< comparisons per item
  static constexpr std::size_t kFew = 48;          ///< items in a cell

  const Segments& segments_;
  Contacts& contacts_;
  std::vector<BoxedItem> active_;
};

/// Tests slab after slab; nothing reaches from one into another.
class SlabTest {
 public:
  SlabTest(const Segments& segments, Contacts& contacts)
      : segments_(segments),
        contacts_(contacts),
        columns_(segments, contacts),
        slanted_(segments, contacts) {}

  void run(std::span<const BoxedItem> slab) {
    verticals_.clear();
    for (const BoxedItem& item : slab) {
      if (is_vertical(item)) verticals_.push_back(item.number);
    }
    columns_.build(verticals_);
    columns_.examine_verticals();
    others_.clear();
    for (const BoxedItem& item : slab) {
      if (contacts_.done()) return;
      if (is_vertical(item)) continue;
      item.is_vertex ? columns_.examine_vertex(item.number) : columns_.examine_slanted(item.number);
      others_.push_back(item);
    }
    slanted_.examine(others_);
  }

 private:
  bool is_vertical(const BoxedItem& item) const {
    if (item.is_vertex) return false;
    const Vector d = segments_.direction(item.number);
    return d.x == 0 && d.y == 0;
  }

  const Segments& segments_;
  Contacts& contacts_;
  SlabColumns columns_;
  SlantedSegments slanted_;
  std::vector<SegmentId> verticals_;
  std::vector<BoxedItem> others_;
};

}  // namespace

void test_by_slabs(const Segments& segments, Contacts& contacts) {
  const std::vector<BoxedItem> items = items_upwards(segments);
  SlabTest test(segments, contacts);
  for (std::size_t begin = 0; begin < items.size() && !contacts.done();) {
    std::int64_t highest = items[begin].box.high.z;
    std::size_t end = begin + 1;
    for (; end < items.size() && items[end].box.low.z <= highest; ++end) {
      highest = std::max(highest, items[end].box.high.z);
    }
    test.run(std::span(items).subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace ar3d::verify
