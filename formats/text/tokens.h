#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "ar3d/formats/text/text_input.h"

namespace ar3d {

/// Returns how many digits stand at `at`, 8 if there are more, and their number in `value`. All
/// eight bytes are read and converted at once (D. Lemire 2018, "Quickly parsing eight digits").
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

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r\v\f") == std::string_view::npos;
}
/// True if the text begins with # or %.
inline bool is_comment(std::string_view text) {
  return !text.empty() && (text[0] == '#' || text[0] == '%');
}

/// The words of the line that a TextInput has just given, separated by blanks, tabs and other white
/// space.
class Tokens {
 public:
  /// @param at  where in the line to begin.
  Tokens(const TextInput& input, std::string_view line, std::size_t at = 0)
      : input_(&input),
        line_(line.data()),
        at_(line.data() + at),
        end_(line.data() + line.size()) {}

  bool done() {
    skip_space();
    return at_ == end_;
  }
  /// The next word; empty at the end of the line.
  std::string_view word() {
    skip_space();
    word_ = at_;
    while (at_ != end_ && !is_space(*at_)) ++at_;
    return {word_, static_cast<std::size_t>(at_ - word_)};
  }
  /// The next word as a decimal number; `what` names it in the message.
  /// @throws InputError if there is none, or it is not a number of at most 64 bits without sign.
  std::uint64_t number(const char* what) {
    skip_space();
    word_ = at_;
    std::uint64_t value = 0;
    const char* limit = end_ - at_ > 18 ? at_ + 18 : end_;  // 18 digits cannot overflow
    if (end_ - at_ >= 8) at_ += leading_digits(at_, value);
    while (at_ != limit && is_digit(*at_)) value = value * 10 + static_cast<unsigned>(*at_++ - '0');
    if (at_ == word_ || (at_ != end_ && !is_space(*at_))) return rare_number(what);
    return value;
  }
  /// Column of the last word or number, from 1.
  std::size_t column() const { return static_cast<std::size_t>(word_ - line_) + 1; }
  /// @throws InputError if the line goes on.
  void expect_done(const char* after_what);
  [[noreturn]] void fail(const std::string& message) const { input_->fail(column(), message); }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip_space() {
    while (at_ != end_ && is_space(*at_)) ++at_;
  }
  std::uint64_t rare_number(const char* what);  // 19 or more digits, or not a number

  const TextInput* input_;
  const char* line_;
  const char* at_;
  const char* end_;
  const char* word_ = line_;
};

/// The next line that is neither blank nor a comment; nothing at the end.
std::optional<std::string_view> next_telling_line(TextInput& input);

/// A line "# vertices N" or "% vertices N", which begins a graph, with "from 0" or "from 1" behind
/// it or without; nothing for other lines.
struct SizeLine {
  std::uint64_t n = 0;
  std::optional<unsigned> base = {};  ///< the smallest id
};
std::optional<SizeLine> size_line(const TextInput& input, std::string_view line);

/// True for a control character, such as a tab: as a part of a name other programs cut there.
constexpr bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

}  // namespace ar3d
