#include "ar3d/results/row_key.h"

#include <fmt/format.h>

#include <charconv>

#include "ar3d/model/error.h"
#include "ar3d/results/columns.h"

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
    throw InputError(fmt::format("'{}' is no row key of 32 hexadecimal digits", text));
  }
  return key;
}

std::string to_string(const RowKey& key) {
  return fmt::format("{:016x}{:016x}", key.high, key.low);
}

RowKey key_of_record(const char* record) {
  static const Column& column = run_column("row_key");
  return parse_row_key({record + column.offset, column.size});
}

}  // namespace ar3d
