#pragma once

#include <cstdint>

namespace ar3d::strips {

/// floor(sqrt(value)) for 0 <= value < 2^62, in integers: the same on every platform.
inline std::int64_t square_root(std::int64_t value) {
  std::int64_t root = 0;
  for (std::int64_t bit = std::int64_t{1} << 30; bit > 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) root += bit;
  }
  return root;
}

}  // namespace ar3d::strips
