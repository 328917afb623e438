// Fields and tables as bytes: journals and results files move records around without knowing what
// their fields mean.
#include "ar3d/store/columns/table.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace ar3d {

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
  std::string fitted = text.substr(0, size);
  std::replace_if(
      fitted.begin(), fitted.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return fitted;
}

}  // namespace ar3d
