#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"

namespace ar3d {

/// Named rows of one kind ("algorithm", "family", "metric"): the project's own, and those that a
/// program built on its library adds. References to rows stay valid.
template <typename Row>
class OpenTable {
 public:
  OpenTable(std::string_view kind, std::vector<Row> rows) : kind_(kind), rows_(std::move(rows)) {
    rows_.reserve(kMostRows);
  }

  const std::vector<Row>& rows() const { return rows_; }

  /// @param is_whole  false if the row lacks one of its functions.
  /// @throws InputError if it does, or its name is empty or taken, or the table is full.
  void add(Row row, bool is_whole) {
    const bool is_taken = std::any_of(rows_.begin(), rows_.end(),
                                      [&](const Row& other) { return other.name == row.name; });
    const bool is_full = rows_.size() == kMostRows;
    if (is_taken || is_full || row.name.empty() || !is_whole) {
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
};

}  // namespace ar3d
