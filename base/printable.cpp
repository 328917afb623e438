// Makes foreign text safe for a terminal or a log. UTF-8 is decoded here, because bytes that are
// none have to be shown one by one.
#include "ar3d/base/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace ar3d {
namespace {

std::uint32_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// Bytes that a UTF-8 character with this first byte has; 0 if none begins so.
std::size_t length_of(std::uint32_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

bool is_printable(std::uint32_t c) {
  if (c < 0x20 || (c >= 0x7f && c < 0xa0)) return false;       // C0, DEL, C1
  if (c == 0x61c || c == 0x200e || c == 0x200f) return false;  // direction marks
  if (c >= 0x2028 && c <= 0x202e) return false;                // ends of lines, overrides
  return c < 0x2066 || c > 0x2069;                             // isolates
}

struct Character {
  std::uint32_t code = 0;
  std::size_t length = 0;  ///< 0: no UTF-8 begins here
};

Character character_at(std::string_view text, std::size_t i) {
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};  // shorter forms are no UTF-8
  constexpr std::uint32_t kFirstBits[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
  const std::size_t length = length_of(byte_at(text, i));
  if (length == 0 || length > text.size() - i) return {};
  std::uint32_t c = byte_at(text, i) & kFirstBits[length];
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte_at(text, i + k) & 0xc0) != 0x80) return {};
    c = c << 6 | (byte_at(text, i + k) & 0x3f);
  }
  const bool is_surrogate = c >= 0xd800 && c < 0xe000;
  if (c < kLeast[length] || is_surrogate || c > 0x10ffff) return {};
  return {c, length};
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-.=+:/,").find(c) != std::string_view::npos;
}

// Eight characters at once, the last eight once more: the top bit of each says that it is none of
// ASCII, is 127, or is below 32. No carry leaves its character but that of 255, which is none.
bool is_plain_ascii(std::string_view text) {
  constexpr std::uint64_t kOnes = 0x0101010101010101;
  constexpr std::uint64_t kTops = kOnes * 128;
  constexpr std::size_t kEight = sizeof(kOnes);
  if (text.size() < kEight)
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
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

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    if (const auto [c, length] = character_at(text, i); length > 0 && is_printable(c)) {
      result += text.substr(i, length);
      i += length;
    } else {
      result += fmt::format("\\x{:02x}", byte_at(text, i++));
    }
  }
  return result;
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_at(text, i).length;
    valid += length > 0 ? text.substr(i, length) : std::string_view("\uFFFD");
    i += std::max<std::size_t>(length, 1);
  }
  return valid;
}

std::string one_line(std::string_view text) {
  std::string line = valid_utf8(text);
  for (char& c : line) {
    if (byte_at({&c, 1}, 0) < 0x20 || c == 0x7f) c = ' ';
  }
  return line;
}

std::string shell_word(std::string_view word) {
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

bool all_printable(std::string_view text) {
  return is_plain_ascii(text) || printable(text) == text;
}

}  // namespace ar3d
