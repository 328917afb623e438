// Tables between analysis and everything that shows it: one writer makes JSON, which page and
// figures read, one makes CSV.
#include "ar3d/analysis/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <nlohmann/json.hpp>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d_page_files.h"

namespace ar3d {
namespace {

bool is_number(const std::string& text) {
  double value = 0;
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* const end = text.data() + text.size();
  return std::from_chars(begin, end, value).ptr == end;
}

void append_columns(const Table& table, std::string& json) {
  for (const TableColumn& column : table.columns) {
    json += fmt::format("{}{{\"name\":{},\"unit\":{},\"meaning\":{},\"type\":\"{}\"}}",
                        &column == table.columns.data() ? "" : ",\n", json_string(column.name),
                        json_string(column.unit), json_string(column.meaning), column.type);
  }
}

void append_rows(const Table& table, std::string& json) {
  for (std::size_t i = 0; i < table.cells.size(); ++i) {
    const std::size_t at = i % table.columns.size();
    json += at > 0 ? "," : i == 0 ? "[" : "],\n[";
    table.cells[i].append_json(table.columns[at].digits, json);
  }
  if (!table.empty()) json += ']';
}

// A shorter number that the page makes of these digits is that of the value itself: where the last
// digit is 0 or 5, a further one says on which side of it the value lies.
void append_rounded(double number, int digits, std::string& text) {
  constexpr int kMostFurther = 6;  // beyond that it is an error of arithmetic
  int some = digits;
  for (; some < digits + kMostFurther; ++some) {
    const std::string shown = fmt::format("{:.{}e}", number, some - 1);
    const char last = shown[shown.find('e') - 1];
    if ((last != '0' && last != '5') || std::strtod(shown.c_str(), nullptr) == number) break;
  }
  fmt::format_to(std::back_inserter(text), "{:.{}g}", number, some);
}

}  // namespace

TableCell::TableCell(double number) {
  if (std::isfinite(number)) value_ = number;
}

TableCell count_or_none(std::int64_t value) { return value < 0 ? TableCell() : TableCell(value); }

void TableCell::append_json(int digits, std::string& text) const {
  const auto out = std::back_inserter(text);
  if (const auto* integer = std::get_if<std::int64_t>(&value_)) {
    fmt::format_to(out, "{}", *integer);
  } else if (const auto* number = std::get_if<double>(&value_)) {
    if (digits == 0) fmt::format_to(out, "{}", *number);
    if (digits != 0) append_rounded(*number, digits, text);
  } else if (const auto* flag = std::get_if<bool>(&value_)) {
    text += *flag ? "true" : "false";
  } else if (const auto* words = std::get_if<std::string>(&value_)) {
    text += json_string(*words);
  } else {
    text += "null";
  }
}

std::string TableCell::csv() const {
  if (const auto* words = std::get_if<std::string>(&value_)) return csv_field(*words);
  std::string text;
  if (!std::holds_alternative<std::monostate>(value_)) append_json(0, text);
  return text;
}

void Table::add(std::vector<TableCell> row) {
  expect(row.size() == columns.size(), "a row has a cell for every column of its table");
  std::ranges::move(row, std::back_inserter(cells));
}

std::vector<Table> empty_tables(std::string_view page) {
  static const auto described = nlohmann::ordered_json::parse(kPageTables);
  std::vector<Table> tables;
  for (const auto& [name, table] : described.at(page).items()) {
    tables.push_back({name, table.at("row_is"), {}});
    for (const auto& column : table.at("columns")) {
      TableColumn& made = tables.back().columns.emplace_back(
          TableColumn{column[0], column[1], column[2], column[3]});
      for (std::size_t i = 4; i < column.size(); ++i) {
        if (column[i].is_boolean()) made.in_csv = column[i];
        if (column[i].is_number()) made.digits = column[i];
      }
    }
  }
  return tables;
}

Table& table_named(std::string_view name, std::vector<Table>& tables) {
  const auto at = std::ranges::find(tables, name, &Table::name);
  expect(at != tables.end(), "analysis/page/tables.json describes every table");
  return *at;
}

std::string table_csv(const Table& table) {
  std::string csv;
  bool is_first = true;
  const auto end_line = [&] { csv += "\r\n", is_first = true; };
  const auto add = [&](const std::string& field) {
    if (!is_first) csv += ',';
    csv += field, is_first = false;
  };
  for (const TableColumn& column : table.columns) {
    if (column.in_csv) add(column.name);
  }
  end_line();
  for (std::size_t i = 0; i < table.cells.size(); ++i) {
    const std::size_t at = i % table.columns.size();
    if (table.columns[at].in_csv) add(table.cells[i].csv());
    if (at + 1 == table.columns.size()) end_line();
  }
  return csv;
}

std::string tables_json(const std::vector<Table>& tables) {
  std::string json = "{\"format\":\"ar3d tables 1\",\n\"tables\":{";
  for (const Table& table : tables) {
    json +=
        fmt::format("{}{}:{{\"row_is\":{},\n\"columns\":[", &table == tables.data() ? "" : ",\n",
                    json_string(table.name), json_string(table.row_is));
    append_columns(table, json);
    json += "],\n\"rows\":[";
    append_rows(table, json);
    json += "]}";
  }
  return json + "}}\n";
}

std::string csv_field(std::string_view raw) {
  std::string text = valid_utf8(raw);
  // Quotes alone do not keep a spreadsheet from computing; an apostrophe in them does.
  const bool is_formula = !text.empty() && !is_number(text) &&
                          std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos;
  if (is_formula) text.insert(0, "'");
  if (!is_formula && text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string json_string(std::string_view text) {
  std::string json;
  for (const char c : nlohmann::json(valid_utf8(text)).dump(-1, ' ', true)) {
    const bool is_special = c == '<' || c == '>' || c == '&';
    json += is_special ? fmt::format("\\u{:04x}", static_cast<int>(c)) : std::string(1, c);
  }
  return json;
}

nlohmann::ordered_json json_number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json key_json(const CurveKey& key) {
  return {{"algorithm", valid_utf8(key.algorithm)},
          {"options", valid_utf8(options_and_level(key))},
          {"family", valid_utf8(key.family)},
          {"parameters", valid_utf8(key.parameters)}};
}

}  // namespace ar3d
