#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ar3d::testing {

/// Tables as `ar3d report --json` writes them, by name: the rows, each an object by column.
inline nlohmann::json rows_by_table(const std::string& json) {
  nlohmann::json named;
  const auto all = nlohmann::json::parse(json).at("tables");
  for (const auto& [name, table] : all.items()) {
    nlohmann::json& rows = named[name] = nlohmann::json::array();
    for (const auto& cells : table.at("rows")) {
      nlohmann::json& row = rows.emplace_back();
      for (std::size_t i = 0; i < cells.size(); ++i) {
        row[table.at("columns").at(i).at("name").get<std::string>()] = cells.at(i);
      }
    }
  }
  return named;
}

/// The same of a page that shows them.
inline nlohmann::json tables_in(const std::string& page) {
  const std::string mark = "id=tables>";
  const std::size_t at = page.find(mark) + mark.size();
  return rows_by_table(page.substr(at, page.find("</script>", at) - at));
}

/// The rows of which a column has that value.
template <class Rows>
std::vector<nlohmann::json> rows_with(const Rows& rows, const char* column,
                                      const nlohmann::json& value) {
  std::vector<nlohmann::json> found;
  for (const auto& row : rows) {
    if (row.at(column) == value) found.push_back(row);
  }
  return found;
}

}  // namespace ar3d::testing
