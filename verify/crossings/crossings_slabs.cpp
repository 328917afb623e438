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

/// A segment or a vertex, with the heights that it covers.
struct Item {
  std::int64_t low;
  std::int64_t high;
  std::uint32_t id;
  bool is_vertex;
  /// By their lower ends; segments before the vertices in which they may begin.
  bool operator<(const Item& other) const {
    return std::tie(low, is_vertex, id) < std::tie(other.low, other.is_vertex, other.id);
  }
};

std::vector<Item> items_of(const Segments& segments) {
  const Drawing& drawing = segments.drawing();
  std::vector<Item> items;
  items.reserve(segments.size() + drawing.num_vertices());
  for (SegmentId s = 0; s < segments.size(); ++s) {
    const std::int64_t begin = segments.from(s).z;
    const std::int64_t end = segments.to(s).z;
    items.push_back({std::min(begin, end), std::max(begin, end), s, false});
  }
  for (std::size_t i = 0; i < drawing.num_vertices(); ++i) {
    const auto v = static_cast<Vertex>(i);
    const std::int64_t z = drawing.vertex(v).z;
    items.push_back({z, z, v, true});
  }
  std::sort(items.begin(), items.end());
  return items;
}

/// Segments that are not vertical against each other and against vertices: upwards, each against
/// those begun before it that reach its lower end; if there are many, by halving space.
class SlantedSegments {
 public:
  SlantedSegments(const Segments& segments, Contacts& contacts)
      : segments_(segments), contacts_(contacts) {}

  /// The items of a slab, upwards.
  void examine(std::span<const Item> items) {
    if (!examine_upwards(items)) examine_by_halving(items);
  }

 private:
  struct Active {
    std::int64_t low_x;
    std::int64_t high_x;
    std::int64_t low_y;
    std::int64_t high_y;
    std::int64_t high;
    SegmentId segment;
  };

  static Active spanned(const Item& item, Point p, Point q) {
    return {std::min(p.x, q.x), std::max(p.x, q.x), std::min(p.y, q.y),
            std::max(p.y, q.y), item.high,          item.id};
  }
  static bool overlap(const Active& a, const Active& b) {
    return a.low_x <= b.high_x && b.low_x <= a.high_x && a.low_y <= b.high_y && b.low_y <= a.high_y;
  }

  /// False if that takes too many comparisons.
  bool examine_upwards(std::span<const Item> items) {
    std::uint64_t left = kPatience * items.size();
    active_.clear();
    for (const Item& item : items) {
      if (contacts_.done()) return true;
      if (active_.size() > left) return false;
      left -= active_.size();
      add(item);
    }
    return true;
  }

  void add(const Item& item) {
    std::erase_if(active_, [&](const Active& old) { return old.high < item.low; });
    const Active added = item.is_vertex
                             ? spanned(item, segments_.drawing().vertex(item.id),
                                       segments_.drawing().vertex(item.id))
                             : spanned(item, segments_.from(item.id), segments_.to(item.id));
    for (const Active& old : active_) {
      if (contacts_.done()) return;
      if (!overlap(old, added)) continue;
      item.is_vertex ? contacts_.examine_vertex(item.id, old.segment)
                     : contacts_.examine(item.id, old.segment);
    }
    if (!item.is_vertex) active_.push_back(added);
  }

  void examine_by_halving(std::span<const Item> items) {
    const auto at = [&](std::uint32_t i) {
      const Item& item = items[i];
      if (item.is_vertex) return SegmentInSpace{segments_.drawing().vertex(item.id), {}};
      return SegmentInSpace{segments_.from(item.id), segments_.direction(item.id)};
    };
    const auto visit = [&](std::uint32_t i, std::uint32_t j) {
      examine_pair(items[i], items[j]);
      return !contacts_.done();
    };
    contacts_.spend(for_each_near_pair(static_cast<std::uint32_t>(items.size()), at, visit, kFew,
                                       contacts_.comparisons_left()));
  }

  void examine_pair(const Item& a, const Item& b) {
    if (a.is_vertex && b.is_vertex) return;
    if (a.is_vertex) return contacts_.examine_vertex(a.id, b.id);
    if (b.is_vertex) return contacts_.examine_vertex(b.id, a.id);
    contacts_.examine(a.id, b.id);
  }

  static constexpr std::uint64_t kPatience = 200;  ///< comparisons per item
  static constexpr std::size_t kFew = 48;          ///< items in a cell

  const Segments& segments_;
  Contacts& contacts_;
  std::vector<Active> active_;
};

/// Tests slab after slab; nothing reaches from one into another.
class SlabTest {
 public:
  SlabTest(const Segments& segments, Contacts& contacts)
      : segments_(segments),
        contacts_(contacts),
        columns_(segments, contacts),
        slanted_(segments, contacts) {}

  void run(std::span<const Item> slab) {
    verticals_.clear();
    for (const Item& item : slab) {
      if (is_vertical(item)) verticals_.push_back(item.id);
    }
    columns_.build(verticals_);
    columns_.examine_verticals();
    others_.clear();
    for (const Item& item : slab) {
      if (contacts_.done()) return;
      if (is_vertical(item)) continue;
      item.is_vertex ? columns_.examine_vertex(item.id) : columns_.examine_slanted(item.id);
      others_.push_back(item);
    }
    slanted_.examine(others_);
  }

 private:
  bool is_vertical(const Item& item) const {
    if (item.is_vertex) return false;
    const Vector d = segments_.direction(item.id);
    return d.x == 0 && d.y == 0;
  }

  const Segments& segments_;
  Contacts& contacts_;
  SlabColumns columns_;
  SlantedSegments slanted_;
  std::vector<SegmentId> verticals_;
  std::vector<Item> others_;
};

}  // namespace

void test_by_slabs(const Segments& segments, Contacts& contacts) {
  const std::vector<Item> items = items_of(segments);
  SlabTest test(segments, contacts);
  for (std::size_t begin = 0; begin < items.size() && !contacts.done();) {
    std::int64_t highest = items[begin].high;
    std::size_t end = begin + 1;
    for (; end < items.size() && items[end].low <= highest; ++end) {
      highest = std::max(highest, items[end].high);
    }
    test.run(std::span(items).subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace ar3d::verify
