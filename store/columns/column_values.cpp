// What people and comparisons see of a run's columns.
#include <fmt/format.h>

#include <cstring>

#include "ar3d/base/error.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

template <class T>
T loaded(const std::string& bytes) {
  T value{};
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

}  // namespace

std::string column_text(const Column& column, const RunRecord& run) {
  std::string bytes(column.size, '\0');
  column.store(run, bytes.data());
  switch (column.type) {
    case FieldType::text:
      return bytes.substr(0, bytes.find('\0'));
    case FieldType::int64:
      return fmt::format("{}", loaded<std::int64_t>(bytes));
    case FieldType::uint64:
      return fmt::format("{}", loaded<std::uint64_t>(bytes));
    case FieldType::float64:
      return fmt::format("{}", loaded<double>(bytes));
  }
  throw InternalError("internal error: unknown column type");
}

double column_number(const Column& column, const RunRecord& run) {
  expect(column.type == FieldType::int64 || column.type == FieldType::float64,
         "a column with a number");
  std::string bytes(column.size, '\0');
  column.store(run, bytes.data());
  if (column.type == FieldType::float64) return loaded<double>(bytes);
  const auto integer = loaded<std::int64_t>(bytes);
  return integer < 0 ? kMissing : static_cast<double>(integer);
}

std::vector<std::string> differing_columns(const RunRecord& a, const RunRecord& b) {
  std::vector<std::string> names;
  for (const Column& column : run_columns()) {
    if (column.kind == ColumnKind::measured) continue;
    std::string left(column.size, '\0'), right(column.size, '\0');
    column.store(a, left.data());
    column.store(b, right.data());
    if (left != right) names.push_back(column.name);
  }
  return names;
}

}  // namespace ar3d
