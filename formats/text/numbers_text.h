#pragma once

#include <fmt/format.h>

#include <string>

namespace ar3d {

/// Appends an integer in decimal; faster than a format string where millions are written.
template <class Integer>
void append_number(std::string& out, Integer value) {
  const fmt::format_int text(value);
  out.append(text.data(), text.size());
}

}  // namespace ar3d
