#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace ar3d {

inline bool is_printable(char c) { return c >= ' ' && c <= '~'; }

/// True if all are printable ASCII, as columns of text hold them.
// Eight characters at once, the last eight once more: the top bit of each says that it is none of
// ASCII, is 127, or is below 32. No carry leaves its character but that of 255, which is none.
inline bool all_printable(const std::string& text) {
  constexpr std::uint64_t kOnes = 0x0101010101010101;
  constexpr std::uint64_t kTops = kOnes * 128;
  constexpr std::size_t kEight = sizeof(kOnes);
  if (text.size() < kEight) return std::all_of(text.begin(), text.end(), is_printable);
  std::uint64_t bad = 0;
  const auto look_at = [&](std::size_t i) {
    std::uint64_t word = 0;
    std::memcpy(&word, text.data() + i, kEight);
    bad |= word | (word + kOnes) | ~((word | kTops) - kOnes * 32);
  };
  for (std::size_t i = 0; i + kEight < text.size(); i += kEight) look_at(i);
  look_at(text.size() - kEight);
  return (bad & kTops) == 0;
}

/// True if a column of so many bytes holds the text as it is.
inline bool fits(const std::string& text, std::size_t size) {
  return text.size() <= size && all_printable(text);
}

}  // namespace ar3d
