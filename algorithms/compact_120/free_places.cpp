// The occupied cells of a strip: rule (d) of Lemma D.6. A random row is often taken; the next free
// one costs a look at a word or two, where another random one would cost all that comes before it.
// Cost: O(1 + rows / 64) per question.
#include "ar3d/algorithms/compact_120/free_places.h"

#include <bit>

namespace ar3d::compact_120 {

FreePlaces::FreePlaces(std::int32_t columns, std::int32_t rows)
    : columns_(static_cast<std::size_t>(columns)),
      rows_(static_cast<std::size_t>(rows)),
      words_(3 * columns_ * rows_ / 64 + 1, ~std::uint64_t{0}) {}

std::int32_t FreePlaces::next_row(Site site, std::int32_t last) const {
  const std::size_t first = bit_of(site);
  const std::size_t end = first + static_cast<std::size_t>(last - site.row) + 1;
  for (std::size_t bit = first; bit < end; bit = (bit / 64 + 1) * 64) {
    const std::uint64_t rest = words_[bit / 64] >> (bit % 64);
    if (rest == 0) continue;
    const std::size_t found = bit + static_cast<std::size_t>(std::countr_zero(rest));
    if (found >= end) break;
    return site.row + static_cast<std::int32_t>(found - first);
  }
  return last + 1;
}

}  // namespace ar3d::compact_120
