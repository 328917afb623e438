#pragma once

#include <optional>
#include <string_view>

#include "ar3d/formats/text/tokens.h"

namespace ar3d {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r\v\f") == std::string_view::npos;
}
/// True if the text begins with # or %.
inline bool is_comment(std::string_view text) {
  return !text.empty() && (text[0] == '#' || text[0] == '%');
}

/// The words of a line "# vertices N", "% vertices N" or "n N" behind its keyword; nothing for
/// other lines.
std::optional<Tokens> size_header(const TextInput& input, std::string_view line);

}  // namespace ar3d
