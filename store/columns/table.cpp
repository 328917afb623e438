// Fields and tables as bytes: journals and results files move records around without knowing what
// their fields mean.
#include "ar3d/store/columns/table.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

/// True for a byte of a UTF-8 character that has begun before.
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

}  // namespace

void store_missing(const Field& field, char* to) {
  const std::int64_t no_integer = -1;
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  std::memset(to, 0, field.size);
  if (field.type == FieldType::int64) std::memcpy(to, &no_integer, sizeof(no_integer));
  if (field.type == FieldType::float64) std::memcpy(to, &no_number, sizeof(no_number));
}

std::string text_of(const Field& field, const char* record) {
  const char* from = record + field.offset;
  return std::string(from, strnlen(from, field.size));
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

}  // namespace ar3d
