#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace ar3d::verify {

/// An item's index in a list of items, and the number that it is sorted by.
template <class Key>
struct KeyedBy {
  Key key;
  std::uint32_t item;
};
using Keyed = KeyedBy<std::uint64_t>;
using ShortKeyed = KeyedBy<std::uint32_t>;  ///< 8 bytes

/// Sorts by key, equal keys as they stand: a counting sort for each digit of `bits` bits of the
/// largest key, the lowest first. @param buffer  of as many items.
template <unsigned bits, class Item>
void sort_by_digits(std::vector<Item>& items, std::vector<Item>& buffer) {
  constexpr std::uint64_t kDigit = (std::uint64_t{1} << bits) - 1;
  std::array<std::uint32_t, kDigit + 1> begin;
  std::uint64_t all = 0;
  for (const Item& item : items) all |= item.key;
  for (unsigned shift = 0; shift < static_cast<unsigned>(std::bit_width(all)); shift += bits) {
    begin.fill(0);
    for (const Item& item : items) ++begin[(item.key >> shift) & kDigit];
    std::uint32_t sum = 0;
    for (auto& count : begin) sum += std::exchange(count, sum);
    for (const Item& item : items) buffer[begin[(item.key >> shift) & kDigit]++] = item;
    std::swap(items, buffer);
  }
}

/// Sorts by key, equal keys as they stand, in O(n) time and in passes that read and write in order.
/// `buffer` is room for as many items, kept between calls. @pre fewer than 2^32 items.
template <class Item>
void sort_by_key(std::vector<Item>& items, std::vector<Item>& buffer) {
  constexpr std::size_t kFew = 24, kMany = 1500;  // as many as digits need to be worth counting
  if (items.size() < kFew) {
    for (std::size_t i = 1; i < items.size(); ++i) {
      const Item item = items[i];
      std::size_t j = i;
      for (; j > 0 && item.key < items[j - 1].key; --j) items[j] = items[j - 1];
      items[j] = item;
    }
    return;
  }
  buffer.resize(items.size());
  items.size() < kMany ? sort_by_digits<8>(items, buffer) : sort_by_digits<11>(items, buffer);
}

}  // namespace ar3d::verify
