// Columns and tables as bytes: journals and results files move records around without knowing what
// their columns mean.
#include "ar3d/store/columns/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

/// True for a byte of a UTF-8 character that has begun before.
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

}  // namespace

void store_missing(const Column& column, char* to) {
  const std::int64_t no_integer = -1;
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  std::memset(to, 0, column.size);
  if (column.type == ColumnType::int64) std::memcpy(to, &no_integer, sizeof(no_integer));
  if (column.type == ColumnType::float64) std::memcpy(to, &no_number, sizeof(no_number));
}

std::string text_of(const Column& column, const char* record) {
  const char* from = record + column.offset;
  return std::string(from, strnlen(from, column.size));
}

std::string fitted_text(const std::string& text, std::size_t size) {
  std::string fitted = text;
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
  const auto is_foreign = [](unsigned char c) { return c > '~'; };
  if (!all_printable(fitted)) std::replace_if(fitted.begin(), fitted.end(), is_control, '?');
  if (!all_printable(fitted)) std::replace_if(fitted.begin(), fitted.end(), is_foreign, '?');
  std::size_t end = std::min(size, fitted.size());
  while (end > 0 && end < fitted.size() && is_continuation(fitted[end])) --end;
  return fitted.substr(0, end);
}

void pack_columns(std::vector<Column>& columns) {
  std::size_t offset = 0;
  for (Column& column : columns) {
    column.offset = offset;
    offset += column.size;
  }
}

std::size_t record_size(const std::vector<Column>& columns) {
  return columns.empty() ? 0 : columns.back().offset + columns.back().size;
}

void RecordPass::store_text(const Column& column, const std::string& value) {
  if (value.size() > column.size || !all_printable(value)) {
    if (cuts_) return store_text(column, fitted_text(value, column.size));
    throw InputError(
        fmt::format("{} '{}' is not {} bytes of printable text", column.name, value, column.size));
  }
  value.copy(to_ + column.offset, value.size());
}

}  // namespace ar3d
