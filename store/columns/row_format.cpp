// Keys of rows: 32 hexadecimal digits in a record, two numbers in memory.
#include "ar3d/store/columns/row_format.h"

#include <fmt/format.h>

#include <charconv>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

bool read_digits(std::string_view digits, std::uint64_t& number) {
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  return read.ec == std::errc() && read.ptr == digits.data() + digits.size();
}

}  // namespace

RowKey parse_row_key(std::string_view text) {
  RowKey key;
  if (text.size() != 32 || !read_digits(text.substr(0, 16), key.high) ||
      !read_digits(text.substr(16), key.low) || to_string(key) != text) {
    throw InputError(fmt::format("'{}' is no row key of 32 hexadecimal digits",
                                 text.substr(0, text.find('\0'))));
  }
  return key;
}

std::string to_string(const RowKey& key) {
  std::string text(32, '0');
  std::uint64_t number = key.low;
  for (std::size_t i = text.size(); i-- > 0; number >>= 4) {
    if (i == 15) number = key.high;
    text[i] = "0123456789abcdef"[number & 15];
  }
  return text;
}

RowKey key_of_record(const RowFormat& format, const char* record) {
  const Field& field = format.rows.fields[format.key];
  return parse_row_key({record + field.offset, field.size});
}

}  // namespace ar3d
