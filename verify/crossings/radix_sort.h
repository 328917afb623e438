#pragma once

#include <cstdint>
#include <vector>

namespace ar3d::verify {

/// An item's place in a list of items, and the number that it is sorted by.
template <class Key>
struct KeyedBy {
  Key key;
  std::uint32_t item;
};
using Keyed = KeyedBy<std::uint64_t>;
using ShortKeyed = KeyedBy<std::uint32_t>;  ///< 8 bytes

/// Sorts by key, equal keys as they stand. O(n) time for each 11 bits of the largest key, in passes
/// that read and write in order; `buffer` is room for as many items, kept between calls.
template <class Item>
void sort_by_key(std::vector<Item>& items, std::vector<Item>& buffer);

}  // namespace ar3d::verify
