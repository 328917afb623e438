#pragma once

#include <cstdint>
#include <vector>

namespace ar3d::verify {

/// An item's place in a list of items, and the number that it is sorted by.
struct Keyed {
  std::uint64_t key;
  std::uint32_t item;
};

/// The same with a key of 32 bits; 8 bytes.
struct ShortKeyed {
  std::uint32_t key;
  std::uint32_t item;
};

/// Sorts by key, equal keys as they stand. O(n) time for each 11 bits of the largest key, in passes
/// that read and write in order; `buffer` is room for as many items, kept between calls.
void sort_by_key(std::vector<Keyed>& items, std::vector<Keyed>& buffer);
void sort_by_key(std::vector<ShortKeyed>& items, std::vector<ShortKeyed>& buffer);

}  // namespace ar3d::verify
