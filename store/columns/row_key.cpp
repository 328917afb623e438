// Keys of rows: 32 hexadecimal digits in a record, two numbers in memory.
#include "ar3d/store/columns/row_key.h"

#include <fmt/compile.h>

#include <charconv>

#include "ar3d/base/error.h"

namespace ar3d {

RowKey parse_row_key(std::string_view text) {
  RowKey key;
  const char* const begin = text.data();
  const bool has_size = text.size() == 32;
  if (has_size) {
    std::from_chars(begin, begin + 16, key.high, 16);
    std::from_chars(begin + 16, begin + 32, key.low, 16);
  }
  if (has_size && to_string(key) == text) return key;
  throw InputError(
      fmt::format("'{}' is no row key of 32 hexadecimal digits", text.substr(0, text.find('\0'))));
}

std::string to_string(const RowKey& key) {
  return fmt::format(FMT_COMPILE("{:016x}{:016x}"), key.high, key.low);
}

}  // namespace ar3d
