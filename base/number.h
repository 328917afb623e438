#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace ar3d {

/// Returns the integer that the whole text is, in decimal digits, behind a minus sign if the type has
/// one; nothing if it is none or does not fit the type.
template <class Integer>
std::optional<Integer> integer_of(std::string_view text) {
  Integer value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace ar3d
