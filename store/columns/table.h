#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ar3d {

enum class ColumnType { text, int64, uint64, float64 };

/// Says what a column of /runs is of; those of other tables are all of one kind.
enum class ColumnKind {
  instance,  ///< describes the instance; also a column of /instances
  run,       ///< with the instance: which run this is
  result,    ///< a pure function of the instance, the algorithm and its options
  metric,    ///< the same: a row of the table of verify/metrics/metrics.h
  measured,  ///< times and memory: differ from run to run
};

/// Describes one column of a table, a fixed number of bytes of every record: the one description
/// from which HDF5 types, JSON, CSV and the schema page are made. A RecordPass makes it.
struct Column {
  std::string name;     ///< snake_case, with the unit as suffix where there is one
  std::string unit;     ///< "s", "bytes", "lattice units", "1" for a pure number, "" for text
  std::string meaning;  ///< one line
  ColumnType type = ColumnType::text;
  std::size_t size = 0;    ///< bytes, at least 1
  std::size_t offset = 0;  ///< in a packed record, see pack_columns
  bool required = true;    ///< a file without it is refused; else its values are missing there
  ColumnKind kind = ColumnKind::run;
};

/// Writes what stands for no value: -1, NaN, 0 (uint64) or an empty text.
void store_missing(const Column& column, char* to);

/// Returns the text of a text column of a record.
std::string text_of(const Column& column, const char* record);

/// Returns `text` as a column holds it: printable UTF-8 of at most `size` bytes, what is none
/// replaced by '?', cut between characters.
std::string fitted_text(const std::string& text, std::size_t size);

/// Lays the columns out one after the other, without gaps.
void pack_columns(std::vector<Column>& columns);

/// Returns bytes of a packed record.
std::size_t record_size(const std::vector<Column>& columns);

/// Describes a table as it is stored: what its records are made of and, of a small one, its
/// records, one after the other.
struct StoredTable {
  std::string name;
  std::string title;
  std::vector<Column> columns;  ///< packed
  std::vector<char> records = {};
  std::size_t size() const { return records.size() / record_size(columns); }
  const char* record(std::size_t i) const { return records.data() + i * record_size(columns); }
};

/// Goes through the columns of a record in the order of its bytes, as one function of the kind of
/// record names them: that function is the schema of its table. A pass describes the columns, writes
/// them into bytes or reads them from there.
class RecordPass {
 public:
  explicit RecordPass(StoredTable& described)
      : described_(&described), columns_(described.columns) {}
  /// Writes to zeros. @throws InputError if a text does not fit its column.
  RecordPass(const std::vector<Column>& columns, char* to) : to_(to), columns_(columns) {}
  /// Reads.
  RecordPass(const std::vector<Column>& columns, const char* from)
      : from_(from), columns_(columns) {}

  void table(const char* name, const char* title) {
    if (described_ != nullptr) *described_ = {name, title, {}};
  }
  /// Says what the columns to come are, and whether a file without one of them is refused.
  void next_are(ColumnKind kind, bool required) { kind_ = kind, required_ = required; }

  /// Text that identifies something: refused, never cut, if it does not fit.
  template <class Text>
  void text(std::string_view name, std::size_t size, Text& value, const char* meaning) {
    const Column* column = next(name, {}, "", meaning, ColumnType::text, size);
    if (column == nullptr) return;
    if (to_ != nullptr) return store_text(*column, value);
    if constexpr (!std::is_const_v<Text>) value = text_of(*column, from_);
  }
  /// Text for people, cut to fit.
  template <class Text>
  void message(std::string_view name, std::size_t size, Text& value, const char* meaning) {
    cuts_ = true;
    text(name, size, value, meaning);
    cuts_ = false;
  }
  /// One of a few names.
  template <class Enum, class Parse>
  void choice(std::string_view name, std::size_t size, Enum& value, const Parse& parse,
              const char* meaning) {
    const Column* column = next(name, {}, "", meaning, ColumnType::text, size);
    if (column == nullptr) return;
    if (to_ != nullptr) return store_text(*column, to_string(value));
    if constexpr (!std::is_const_v<Enum>) value = parse(text_of(*column, from_));
  }
  template <class Number>
  void number(std::string_view name, const char* unit, Number& value, const char* meaning,
              std::string_view suffix = {}) {
    const Column* column = next(name, suffix, unit, meaning, type_of<Number>(), sizeof(value));
    if (column == nullptr) return;
    if (to_ != nullptr) std::memcpy(to_ + column->offset, &value, sizeof(value));
    if constexpr (!std::is_const_v<Number>) {
      if (from_ != nullptr) std::memcpy(&value, from_ + column->offset, sizeof(value));
    }
  }
  /// One column for each entry, named by `suffixes`.
  template <class Array, std::size_t N>
  void array(std::string_view name, const char* unit, Array& values,
             const std::array<const char*, N>& suffixes, const char* meaning) {
    for (std::size_t i = 0; i < N; ++i) number(name, unit, values[i], meaning, suffixes[i]);
  }

 private:
  template <class Number>
  static constexpr ColumnType type_of() {
    using Value = std::remove_const_t<Number>;
    return std::is_same_v<Value, double>          ? ColumnType::float64
           : std::is_same_v<Value, std::uint64_t> ? ColumnType::uint64
                                                  : ColumnType::int64;
  }
  // The column that comes now; null if it is only described.
  const Column* next(std::string_view name, std::string_view suffix, const char* unit,
                     const char* meaning, ColumnType type, std::size_t size) {
    if (described_ != nullptr) {
      described_->columns.push_back(
          {std::string(name).append(suffix), unit, meaning, type, size, 0, required_, kind_});
      return nullptr;
    }
    return &columns_[next_++];
  }
  void store_text(const Column& column, const std::string& value);

  StoredTable* described_ = nullptr;
  const char* from_ = nullptr;
  char* to_ = nullptr;
  const std::vector<Column>& columns_;
  std::size_t next_ = 0;
  ColumnKind kind_ = ColumnKind::run;
  bool required_ = true;
  bool cuts_ = false;
};

}  // namespace ar3d
