#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "ar3d/formats/text/text_input.h"
#include "ar3d/formats/text/tokens.h"

// Nearly all lines of large files are plain: numbers with one blank between them. They are read
// here, several times as fast as word by word; whatever else a line may be, and whatever is wrong
// with it, is left to the formats' own readers.
namespace ar3d {

/// A number of at most 16 digits, without zeros in front, at `at`, which moves behind it; false if
/// there is none.
inline bool read_plain_number(const char*& at, std::uint64_t& value) {
  const char* const first = at;
  const unsigned count = leading_digits(at, value);
  at += count;
  if (count > 1 && *first == '0') return false;  // 007 is left to the caller
  if (count < 8) return count > 0;
  std::uint64_t more = 0;
  const unsigned further = leading_digits(at, more);
  constexpr std::uint64_t kPowers[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000};
  if (further == 8) return false;
  value = value * kPowers[further] + (further > 0 ? more : 0);
  at += further;
  return true;
}

/// Reads lines of two numbers, "u v" behind `before`, for as long as they are plain: one blank or
/// tab between the numbers, nothing else, use(u, v, line number) true. The first other line (and
/// whatever is wrong with it) is left to the caller.
/// @param most  read no more lines than that.  @return their number.
template <class Use>
std::uint64_t read_plain_pairs(TextInput& input, std::string_view before, std::uint64_t most,
                               Use use) {
  const std::string_view text = input.whole_lines();
  const char* line = text.data();
  const char* const end = line + text.size();
  std::uint64_t lines = 0;
  for (; lines < most && line != end; ++lines) {  // the last line ends the text: no read beyond it
    if (!std::string_view(line, static_cast<std::size_t>(end - line)).starts_with(before)) break;
    const char* at = line + before.size();
    std::uint64_t u = 0;
    std::uint64_t v = 0;
    if (!read_plain_number(at, u) || (*at != ' ' && *at != '\t')) break;
    if (!read_plain_number(++at, v)) break;
    if (*at == '\r') ++at;
    if (*at != '\n' || !use(u, v, input.line() + lines + 1)) break;
    line = at + 1;
  }
  input.take(static_cast<std::size_t>(line - text.data()), lines);
  return lines;
}

/// Reads a line "a b c …" at `at`, which moves behind its end: at most ids.size() numbers, one
/// blank or tab between them (before the first, too, if `led`). @return how many; ids.size() + 1
/// if the line is not like that.
template <std::size_t most>
std::size_t read_plain_ids(const char*& at, bool led, std::array<std::uint64_t, most>& ids) {
  std::size_t count = 0;
  while (*at != '\n' && *at != '\r') {
    if ((led || count > 0) && *at != ' ' && *at != '\t') return most + 1;
    if (led || count > 0) ++at;
    if (count == most || !read_plain_number(at, ids[count])) return most + 1;
    ++count;
  }
  if (*at == '\r') ++at;
  return *at++ == '\n' ? count : most + 1;
}

/// Reads lines of neighbours, "a b c …" or, if `named`, "u: a b c …", for as long as they are plain
/// (read_plain_ids, up to 16 neighbours) and use(u, neighbours, line number) is true; u is 0 in
/// lines without names. The first other line (and whatever is wrong with it) is left to the caller.
/// @param most  read no more lines than that.  @return their number.
template <class Use>
std::uint64_t read_plain_rows(TextInput& input, bool named, std::uint64_t most, Use use) {
  const std::string_view text = input.whole_lines();
  const char* line = text.data();
  const char* const end = line + text.size();
  std::array<std::uint64_t, 16> ids{};
  std::uint64_t lines = 0;
  for (; lines < most && line != end; ++lines) {  // the last line ends the text: no read beyond it
    const char* at = line;
    std::uint64_t u = 0;
    if (named && (!read_plain_number(at, u) || *at++ != ':')) break;
    const std::size_t count = read_plain_ids(at, named, ids);
    if (count > ids.size()) break;
    if (!use(u, std::span(ids.data(), count), input.line() + lines + 1)) break;
    line = at;
  }
  input.take(static_cast<std::size_t>(line - text.data()), lines);
  return lines;
}

}  // namespace ar3d
