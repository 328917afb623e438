#pragma once

#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "ar3d/store/columns/table.h"

namespace ar3d {

/// Goes through the columns of a record in the order of its bytes, as one function of the kind of
/// record names them: that function is the schema of its table. A pass describes the columns, writes
/// them into bytes or reads them from there.
class RecordPass {
 public:
  explicit RecordPass(StoredTable& described)
      : described_(&described), columns_(described.columns) {}
  /// Writes to zeros. @param first  column that is named first. @throws InputError if a text does
  /// not fit its column.
  static RecordPass writing(const std::vector<Column>& columns, char* to, std::size_t first = 0) {
    return {columns, nullptr, to, first};
  }
  static RecordPass reading(const std::vector<Column>& columns, const char* from,
                            std::size_t first = 0) {
    return {columns, from, nullptr, first};
  }

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
  RecordPass(const std::vector<Column>& columns, const char* from, char* to, std::size_t first)
      : from_(from), to_(to), columns_(columns), next_(first) {}
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
