#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"

namespace ar3d {

/// Holds named rows of one kind ("algorithm", "family", "metric"): the project's own, and those
/// that a program built on its library adds. References to rows stay valid.
template <typename Row>
class OpenTable {
 public:
  /// @param is_whole  false of a row that lacks one of its functions.
  OpenTable(std::string_view kind, std::vector<Row> rows, bool (*is_whole)(const Row&))
      : kind_(kind), rows_(std::move(rows)), is_whole_(is_whole) {
    rows_.reserve(kMostRows);
  }

  const std::vector<Row>& rows() const { return rows_; }

  /// Returns the row of that name; null if there is none.
  const Row* find(std::string_view name) const {
    const auto at =
        std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.name == name; });
    return at == rows_.end() ? nullptr : &*at;
  }

  /// @throws InputError if the row lacks one of its functions, or its name is empty or taken, or
  /// the table is full.
  void add(Row row) {
    const bool is_taken = find(row.name) != nullptr;
    const bool is_full = rows_.size() == kMostRows;
    if (is_taken || is_full || row.name.empty() || !is_whole_(row)) {
      throw InputError(fmt::format("{} '{}' cannot be added: {}", kind_, row.name,
                                   is_taken  ? "the name is taken"
                                   : is_full ? "the table is full"
                                             : "it has no name or lacks a function"));
    }
    rows_.push_back(std::move(row));
  }

 private:
  static constexpr std::size_t kMostRows = 1000;
  std::string_view kind_;
  std::vector<Row> rows_;
  bool (*is_whole_)(const Row&);
};

}  // namespace ar3d
