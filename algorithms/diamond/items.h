#pragma once

// Step 1.2: the green and the red items (paths, cycles and single vertices of one colour).

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "ar3d/algorithms/diamond/colouring.h"
#include "ar3d/base/long_vector.h"

namespace ar3d::diamond {

/// The components of one colour, laid end to end: item i is the range begin[i] .. begin[i+1] of
/// `vertex`, which holds every vertex of the graph once. edge[p] joins vertex[p] to the next vertex
/// of its item; at the last vertex of a cycle it is the closing edge back to the item's first
/// vertex, at the end of a path it is kNone.
struct Items {
  std::vector<Vertex> vertex;
  std::vector<EdgeId> edge;
  std::vector<std::uint32_t> begin{0};

  std::uint32_t count() const { return static_cast<std::uint32_t>(begin.size() - 1); }
  std::uint32_t size(std::uint32_t item) const { return begin[item + 1] - begin[item]; }
  bool is_cycle(std::uint32_t item) const { return edge[begin[item + 1] - 1] != kNone; }
  Vertex first(std::uint32_t item) const { return vertex[begin[item]]; }
  Vertex last(std::uint32_t item) const { return vertex[begin[item + 1] - 1]; }
  std::span<const Vertex> of(std::uint32_t item) const {
    return {vertex.data() + begin[item], size(item)};
  }

  /// Makes the edge that leaves the item's position `p` (0-based within the cycle) its closing
  /// edge.
  void close_at(std::uint32_t item, std::uint32_t p);
};

/// Calls visit(position, item) for the positions begin, ..., end - 1 of Items::vertex, in order.
template <class Visit>
void for_each_position(const Items& items, std::size_t begin, std::size_t end, const Visit& visit) {
  if (begin == end) return;
  const auto after = std::upper_bound(items.begin.begin(), items.begin.end(), begin);
  auto item = static_cast<std::uint32_t>(after - items.begin.begin()) - 1;
  for (auto p = static_cast<std::uint32_t>(begin); p < end; ++p) {
    while (p >= items.begin[item + 1]) ++item;
    visit(p, item);
  }
}

/// Items of one colour: paths by their first vertex, then cycles by their smallest vertex. Cost:
/// O(n).
Items extract_items(const std::vector<HalfEdge>& next);

/// Number of items that are cycles (m_green or m_red of the paper).
std::uint32_t count_cycles(const Items& items);

/// Holds where each vertex stands: its position in Items::vertex, and its item.
struct ItemPosition {
  std::uint32_t position = 0;
  std::uint32_t item = 0;
};
using Whereabouts = UnwrittenVector<ItemPosition>;
Whereabouts whereabouts(const Items& items);

/// A list of the items with a direction for each: what remains when a colour's items are put in
/// order.
struct ItemInOrder {
  std::uint32_t item = 0;
  bool reversed = false;
};
using Arrangement = std::vector<ItemInOrder>;

/// The items in the arrangement's order and directions; reversing keeps the closing edge of a
/// cycle. Cost: O(n), and O(items) if they are in this order already.
Items arranged(Items items, const Arrangement& arrangement);

/// How many elements ahead are prefetched where an order is known but memory is read at random.
inline constexpr std::size_t kAhead = 16;

/// Calls visit(i, array[order[i]]) for i = begin, ..., end - 1, and prefetches elements, beyond
/// `end` too: the next range is often next.
template <class Order, class Array, class Visit>
void for_each_ahead(const Order& order, Array& array, std::size_t begin, std::size_t end,
                    Visit visit) {
  constexpr int kWritten = std::is_const_v<Array> ? 0 : 1;
  const std::size_t known = order.size() < kAhead ? 0 : order.size() - kAhead;
  std::size_t i = begin;
  for (const std::size_t stop = std::min(end, known); i < stop; ++i) {
    __builtin_prefetch(&array[order[i + kAhead]], kWritten);
    visit(i, array[order[i]]);
  }
  for (; i < end; ++i) visit(i, array[order[i]]);
}

}  // namespace ar3d::diamond
