#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace ar3d {

/// How many digits stand at `at`, 8 if there are more, and their number in `value`. All eight bytes
/// are read and converted at once (D. Lemire 2018, "Quickly parsing eight digits").
/// @param at  8 readable bytes.
inline unsigned leading_digits(const char* at, std::uint64_t& value) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, at, sizeof bytes);
  if constexpr (std::endian::native == std::endian::big) bytes = __builtin_bswap64(bytes);
  const std::uint64_t digits = bytes ^ 0x3030303030303030;  // '0'..'9' become 0..9
  // The high bit of every byte that is no digit; the first such byte may spoil those behind it
  // only.
  const std::uint64_t others = ((digits + 0x7676767676767676) | digits) & 0x8080808080808080;
  const unsigned count = others == 0 ? 8 : static_cast<unsigned>(std::countr_zero(others)) / 8;
  if (count == 0) return 0;
  std::uint64_t v = digits << (64 - 8 * count);  // zeros in front
  v = (v * 10 + (v >> 8)) & 0x00ff00ff00ff00ff;
  v = (v * 100 + (v >> 16)) & 0x0000ffff0000ffff;
  value = (v * 10000 + (v >> 32)) & 0xffffffff;
  return count;
}

}  // namespace ar3d
