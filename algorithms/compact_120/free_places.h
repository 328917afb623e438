#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/compact_120/letters.h"
#include "ar3d/base/long_vector.h"

namespace ar3d::compact_120 {

/// Which places of a strip are free: one bit per cell and class, rows of one column and class in
/// line.
class FreePlaces {
 public:
  FreePlaces(std::int32_t columns, std::int32_t rows);

  bool is_free(Site site) const {
    const std::size_t bit = bit_of(site);
    return (words_[bit / 64] >> (bit % 64) & 1) != 0;
  }
  void flip(Site site) {
    const std::size_t bit = bit_of(site);
    words_[bit / 64] ^= std::uint64_t{1} << (bit % 64);
  }

  /// The first free row of the site's column and class from its own row on, not beyond `last`;
  /// larger than that if there is none. O(1 + rows / 64).
  std::int32_t next_row(Site site, std::int32_t last) const;

 private:
  std::size_t bit_of(Site site) const {
    return (static_cast<std::size_t>(site.of) * columns_ + static_cast<std::size_t>(site.column)) *
               rows_ +
           static_cast<std::size_t>(site.row);
  }

  std::size_t columns_;
  std::size_t rows_;
  LongVector<std::uint64_t> words_;  ///< 1: free
};

}  // namespace ar3d::compact_120
