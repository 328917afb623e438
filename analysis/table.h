#pragma once

#include <concepts>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "ar3d/store/columns/curves.h"

namespace ar3d {

/// Represents one value of a table; missing if nothing is given, or a number is not finite.
class TableCell {
 public:
  TableCell() = default;
  TableCell(std::string text) : value_(std::move(text)) {}
  TableCell(const char* text) : value_(std::string(text)) {}
  TableCell(double number);
  TableCell(bool flag) : value_(flag) {}
  template <class Value>
  TableCell(const std::optional<Value>& value) {
    if (value) *this = TableCell(*value);
  }
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) TableCell(Integer integer)
      : value_(static_cast<std::int64_t>(integer)) {}

  /// Appends it as JSON, numbers with so many significant digits, or a few more where rounding what
  /// is written to fewer digits would not be rounding the number; 0: the shortest that reads back as
  /// the same. Nothing in it ends a script element.
  void append_json(int digits, std::string& text) const;
  /// Returns it as a field of RFC 4180; empty if missing.
  std::string csv() const;

 private:
  std::variant<std::monostate, std::int64_t, double, bool, std::string> value_;
};

/// Returns the number, or a missing cell if it is negative.
TableCell count_or_none(std::int64_t value);

/// Describes a column of a table as analysis/page/tables.json does.
struct TableColumn {
  std::string name;
  std::string type;          ///< integer, number, text or flag
  std::string unit = {};     ///< empty: a plain number, or no number
  std::string meaning = {};  ///< one line
  int digits = 6;            ///< of numbers in JSON; 0: all
  bool in_csv = true;        ///< false: it is for the page only
};

/// Holds what analysis finds, to be shown: named, typed columns and rows. It knows no
/// page.
struct Table {
  std::string name;
  std::string row_is;  ///< what one row is, a few words
  std::vector<TableColumn> columns;
  std::vector<TableCell> cells = {};  ///< row after row

  /// Adds a row.
  /// @param row  as many cells as there are columns.
  void add(std::vector<TableCell> row);
  std::size_t size() const { return cells.size() / columns.size(); }
  bool empty() const { return cells.empty(); }
};

/// Returns the tables of a page, "report" or "history", without rows: analysis/page/tables.json says
/// which there are, and what their columns mean.
std::vector<Table> empty_tables(std::string_view page);
/// Returns the one with this name, which has to be there.
Table& table_named(std::string_view name, std::vector<Table>& tables);

/// Returns the names of the columns, then a line a row (RFC 4180).
std::string table_csv(const Table& table);

/// Returns {"format": …, "tables": {NAME: {"row_is": …, "columns": [{"name", "unit", "meaning",
/// "type"}, …], "rows": [[…], …]}, …}} in ASCII. Nothing in it ends a script element.
std::string tables_json(const std::vector<Table>& tables);

/// Returns a field of a line of CSV, quoted where RFC 4180 asks for it.
std::string csv_field(std::string_view raw);
/// Returns a JSON string that may stand in a script element. ASCII.
std::string json_string(std::string_view text);

/// Returns the number, or null if it is not finite.
nlohmann::ordered_json json_number(double value);

/// Returns algorithm, options (with the level), family and parameters.
nlohmann::ordered_json key_json(const CurveKey& key);

}  // namespace ar3d
