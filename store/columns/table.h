#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ar3d/store/columns/field.h"

namespace ar3d {

/// A table as it is stored: what its records are made of.
struct TableSpec {
  std::string name;
  std::string title;
  std::vector<Field> fields;  ///< packed
};

/// A small table with its records, one after the other.
struct StoredTable {
  TableSpec spec;
  std::vector<char> records;
  std::size_t size() const { return records.size() / record_size(spec.fields); }
  const char* record(std::size_t i) const { return records.data() + i * record_size(spec.fields); }
};

}  // namespace ar3d
