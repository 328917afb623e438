#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

#include "ar3d/base/printable.h"

namespace ar3d {

/// Writes what people read, wherever the values come from: no escape sequence of theirs reaches the
/// terminal. Everything that a verb says goes through here; what is data for programs (drawings,
/// graphs, JSON) does not. A message that standard error does not take is lost, since no reader can be
/// told. @throws std::system_error where another file does not take it.
template <class... Values>
void say(std::FILE* to, fmt::format_string<Values...> format, Values&&... values) {
  const std::string text = printable_lines(fmt::format(format, std::forward<Values>(values)...));
  if (to == stderr) {
    (void)std::fwrite(text.data(), 1, text.size(), to);
  } else {
    fmt::print(to, "{}", text);
  }
}

template <class... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  say(stdout, format, std::forward<Values>(values)...);
}

}  // namespace ar3d
