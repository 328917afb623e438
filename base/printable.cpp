// Makes foreign text safe for a terminal or a log. Boost decodes UTF-8, one character at a time,
// because bytes that are none have to be shown one by one.
#include "ar3d/base/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/locale/utf.hpp>
#include <cstdint>

namespace ar3d {
namespace {

std::uint32_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

bool is_printable(std::uint32_t c) {
  if (c < 0x20 || (c >= 0x7f && c < 0xa0)) return false;       // C0, DEL, C1
  if (c == 0x61c || c == 0x200e || c == 0x200f) return false;  // direction marks
  if (c >= 0x2028 && c <= 0x202e) return false;                // ends of lines, overrides
  return c < 0x2066 || c > 0x2069;                             // isolates
}

// The character that begins there, and its length; 0 if no UTF-8 begins there.
std::pair<std::uint32_t, std::size_t> character_at(std::string_view text, std::size_t i) {
  auto at = text.begin() + static_cast<std::ptrdiff_t>(i);
  const auto begin = at;
  const std::uint32_t code = boost::locale::utf::utf_traits<char>::decode(at, text.end());
  if (!boost::locale::utf::is_valid_codepoint(code)) return {};
  return {code, static_cast<std::size_t>(at - begin)};
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-.=+:/,").find(c) != std::string_view::npos;
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
    const std::size_t length = character_at(text, i).second;
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
  return "'" + boost::algorithm::replace_all_copy(std::string(word), "'", "'\\''") + "'";
}

bool all_printable(std::string_view text) {
  unsigned others = 0;  // than printable ASCII; without a branch, so that many are seen at once
  for (std::size_t i = 0; i < text.size(); ++i) others |= text[i] < ' ' || text[i] > '~';
  return others == 0 || printable(text) == text;
}

std::string printable_lines(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\n\t"), text.size());
    result += printable(text.substr(0, end));
    if (end < text.size()) result += text[end];
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace ar3d
