#include "ar3d/verify/order.h"

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
void sort_by_digit(const std::vector<Keyed>& from, unsigned shift, std::vector<Keyed>& to) {
  std::array<std::size_t, kDigit + 1> place{};
  for (const Keyed& item : from) ++place[(item.key >> shift) & kDigit];
  std::size_t begin = 0;
  for (auto& count : place) begin += std::exchange(count, begin);
  for (const Keyed& item : from) to[place[(item.key >> shift) & kDigit]++] = item;
}

}  // namespace

void sort_by_key(std::vector<Keyed>& items, std::vector<Keyed>& buffer) {
  constexpr std::size_t kFew = 256;  // below, counting the digits costs more than comparing
  if (items.size() < kFew) {
    std::stable_sort(items.begin(), items.end(),
                     [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
    return;
  }
  std::uint64_t all = 0;
  for (const Keyed& item : items) all |= item.key;
  buffer.resize(items.size());
  for (unsigned shift = 0; shift < static_cast<unsigned>(std::bit_width(all));
       shift += kDigitBits) {
    sort_by_digit(items, shift, buffer);
    std::swap(items, buffer);
  }
}

}  // namespace ar3d::verify
