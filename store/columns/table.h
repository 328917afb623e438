#pragma once

#include <string>
#include <vector>

namespace ar3d {

enum class FieldType { text, int64, uint64, float64 };

/// Describes one fixed-size field of a table's record.
struct Field {
  std::string name;     ///< snake_case, with the unit as suffix where there is one
  std::string unit;     ///< "s", "bytes", "lattice units", "1" for a pure number, "" for text
  std::string meaning;  ///< one line
  FieldType type = FieldType::text;
  std::size_t size = 0;    ///< bytes, at least 1
  std::size_t offset = 0;  ///< in a packed record, see pack_fields
  bool required = true;    ///< a file without it is refused; else its values are missing there
};

/// Writes what stands for no value: -1, NaN, 0 (uint64) or an empty text.
void store_missing(const Field& field, char* to);

/// Returns the text of a text field of a record.
std::string text_of(const Field& field, const char* record);

/// Returns `text` as a field holds it: printable UTF-8 of at most `size` bytes, what is none
/// replaced by '?', cut between characters.
std::string fitted_text(const std::string& text, std::size_t size);

/// Lays the fields out one after the other, without gaps.
template <class FieldLike>
void pack_fields(std::vector<FieldLike>& fields) {
  std::size_t offset = 0;
  for (FieldLike& field : fields) {
    field.offset = offset;
    offset += field.size;
  }
}

/// Returns bytes of a packed record.
template <class FieldLike>
std::size_t record_size(const std::vector<FieldLike>& fields) {
  return fields.empty() ? 0 : fields.back().offset + fields.back().size;
}

/// Describes a table as it is stored: what its records are made of.
struct TableSpec {
  std::string name;
  std::string title;
  std::vector<Field> fields;  ///< packed
};

/// Describes a small table with its records, one after the other.
struct StoredTable {
  TableSpec spec;
  std::vector<char> records;
  std::size_t size() const { return records.size() / record_size(spec.fields); }
  const char* record(std::size_t i) const { return records.data() + i * record_size(spec.fields); }
};

}  // namespace ar3d
