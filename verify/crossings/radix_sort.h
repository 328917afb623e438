#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
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

/// Sorts by key, equal keys as they stand: a counting sort for each 11 bits of the largest key, the
/// lowest first, in O(n) time and in passes that read and write in order. `buffer` is room for as
/// many items, kept between calls.
template <class Item>
void sort_by_key(std::vector<Item>& items, std::vector<Item>& buffer) {
  constexpr std::size_t kFew = 256;  // below, counting the digits costs more than comparing
  constexpr unsigned kDigitBits = 11;
  constexpr std::uint64_t kDigit = (std::uint64_t{1} << kDigitBits) - 1;
  if (items.size() < kFew) {
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& a, const Item& b) { return a.key < b.key; });
    return;
  }
  std::uint64_t all = 0;
  for (const Item& item : items) all |= item.key;
  buffer.resize(items.size());
  for (unsigned shift = 0; shift < static_cast<unsigned>(std::bit_width(all));
       shift += kDigitBits) {
    std::vector<std::size_t> place(kDigit + 1);  // 16 KiB, which a small stack has not
    for (const Item& item : items) ++place[(item.key >> shift) & kDigit];
    std::size_t begin = 0;
    for (auto& count : place) begin += std::exchange(count, begin);
    for (const Item& item : items) buffer[place[(item.key >> shift) & kDigit]++] = item;
    std::swap(items, buffer);
  }
}

}  // namespace ar3d::verify
