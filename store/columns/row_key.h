#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace ar3d {

/// Describes the 128-bit identity of a row: its 32 hexadecimal digits as two numbers.
struct RowKey {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  auto operator<=>(const RowKey&) const = default;
};

/// @throws InputError if the text is not 32 lower-case hexadecimal digits.
RowKey parse_row_key(std::string_view text);
std::string to_string(const RowKey& key);

}  // namespace ar3d

/// Takes the key, which is a hash already.
template <>
struct std::hash<ar3d::RowKey> {
  std::size_t operator()(const ar3d::RowKey& key) const noexcept { return key.low; }
};
