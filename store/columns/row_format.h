#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/store/columns/table.h"

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

/// Holds what the rows of a study are made of. Journals and results files store any list of fields
/// and know none by name; those whose meaning they need are told here, by their positions.
struct RowFormat {
  TableSpec rows;
  std::size_t key = 0;      ///< 32 hexadecimal digits that tell rows apart; the first field
  std::size_t status = 0;   ///< a text; rows with another one than "ok" are counted
  std::size_t session = 0;  ///< int64: which session made the row
  /// Holds a table that follows from the rows: for every value of the fields `extract_key` of a row
  /// one record, made of the fields `extract_fields` of the first row that has it.
  TableSpec extract;
  std::vector<std::size_t> extract_fields, extract_key;
  std::vector<TableSpec> tables;  ///< small tables that stand beside the rows

  std::size_t record_size() const { return ar3d::record_size(rows.fields); }
};

/// Returns the key of a record. @throws InputError as parse_row_key.
RowKey key_of_record(const RowFormat& format, const char* record);

/// Describes rows that are made or fetched one at a time; `read` writes record i.
struct RecordSource {
  std::size_t count = 0;
  std::function<void(std::size_t i, char* record)> read;
};

}  // namespace ar3d

/// A key is a hash already.
template <>
struct std::hash<ar3d::RowKey> {
  std::size_t operator()(const ar3d::RowKey& key) const noexcept { return key.low; }
};
