// What is rare among words: numbers of 19 digits or more, errors, and the size lines of lists.
#include "ar3d/formats/text/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace ar3d {

std::uint64_t Tokens::rare_number(const char* what) {
  at_ = word_;
  const std::string_view text = word();
  if (text.empty()) fail(fmt::format("expected {}, found the end of the line", what));
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range && stop == text.data() + text.size()) {
    fail(fmt::format("{} {} does not fit 64 bits", what, shown(text)));
  }
  if (error != std::errc() || stop != text.data() + text.size()) {
    fail(fmt::format("expected {}, found {}", what, shown(text)));
  }
  return value;
}

void Tokens::expect_done(const char* after_what) {
  if (done()) return;
  const std::string_view text = word();
  fail(fmt::format("unexpected {} after {}", shown(text), after_what));
}

std::optional<std::string_view> next_telling_line(TextInput& input) {
  std::optional<std::string_view> line = input.next_line();
  while (line && (is_blank(*line) || is_comment(*line))) line = input.next_line();
  return line;
}

std::optional<SizeLine> size_line(const TextInput& input, std::string_view line) {
  if (!is_comment(line)) return std::nullopt;
  Tokens tokens(input, line);
  if (tokens.word().size() != 1 || tokens.word() != "vertices") return std::nullopt;
  Tokens number = tokens;
  const std::string_view digits = number.word();
  if (digits.empty() || !std::ranges::all_of(digits, is_digit)) return std::nullopt;
  SizeLine sizes{tokens.number("a number of vertices")};
  if (tokens.done()) return sizes;
  const bool is_from = tokens.word() == "from";
  const std::string_view base = tokens.word();
  if (!is_from || (base != "0" && base != "1") || !tokens.done()) return std::nullopt;
  sizes.base = base == "1" ? 1 : 0;
  return sizes;
}

}  // namespace ar3d
