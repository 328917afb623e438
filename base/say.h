#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace ar3d {

/// Several lines as they may stand on a terminal: as printable() makes them, but ends of lines and
/// tabulators stay.
std::string printable_lines(std::string_view text);

/// Writes what people read, whoever wrote the values: no escape sequence of theirs reaches the
/// terminal. Everything that a verb says goes through here; what is data for programs (drawings,
/// graphs, JSON) does not.
template <class... Values>
void say(std::FILE* to, fmt::format_string<Values...> format, Values&&... values) {
  fmt::print(to, "{}", printable_lines(fmt::format(format, std::forward<Values>(values)...)));
}

template <class... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  say(stdout, format, std::forward<Values>(values)...);
}

}  // namespace ar3d
