#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

#include "ar3d/base/printable.h"

namespace ar3d {

/// Prints what people read; no escape sequence among the values reaches the terminal. Data for
/// programs (drawings, graphs, JSON) goes elsewhere. What standard error does not take is lost.
/// @throws std::system_error where another file does not take it.
template <class... Values>
void print(std::FILE* to, fmt::format_string<Values...> format, Values&&... values) {
  const std::string text = printable_lines(fmt::format(format, std::forward<Values>(values)...));
  if (to == stderr) {
    (void)std::fwrite(text.data(), 1, text.size(), to);
  } else {
    fmt::print(to, "{}", text);
  }
}

template <class... Values>
void print(fmt::format_string<Values...> format, Values&&... values) {
  ar3d::print(stdout, format, std::forward<Values>(values)...);
}

}  // namespace ar3d
