// Sorts items by their keys, 11 bits at a time from the lowest. Equal keys keep their order, and
// every pass reads and writes in order.
#include "ar3d/verify/crossings/radix_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>

namespace ar3d::verify {
namespace {

constexpr unsigned kDigitBits = 11;
constexpr std::uint64_t kDigit = (std::uint64_t{1} << kDigitBits) - 1;

/// One pass of a least-significant-digit radix sort: a stable counting sort by one digit.
template <class Item>
void sort_by_digit(const std::vector<Item>& from, unsigned shift, std::vector<Item>& to) {
  std::array<std::size_t, kDigit + 1> place{};
  for (const Item& item : from) ++place[(item.key >> shift) & kDigit];
  std::size_t begin = 0;
  for (auto& count : place) begin += std::exchange(count, begin);
  for (const Item& item : from) to[place[(item.key >> shift) & kDigit]++] = item;
}

}  // namespace

template <class Item>
void sort_by_key(std::vector<Item>& items, std::vector<Item>& buffer) {
  constexpr std::size_t kFew = 256;  // below, counting the digits costs more than comparing
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
    sort_by_digit(items, shift, buffer);
    std::swap(items, buffer);
  }
}

template void sort_by_key(std::vector<Keyed>& items, std::vector<Keyed>& buffer);
template void sort_by_key(std::vector<ShortKeyed>& items, std::vector<ShortKeyed>& buffer);

}  // namespace ar3d::verify
