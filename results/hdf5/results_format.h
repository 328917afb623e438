#pragma once

// What writer and reader of a results file share. The page results/SCHEMA.md describes it.

#include <algorithm>
#include <string>
#include <vector>

#include "ar3d/results/columns.h"
#include "ar3d/results/hdf5/hdf5_table.h"

namespace ar3d {

inline constexpr const char* kResultsFormat = "ar3d-results";
inline constexpr long long kResultsFormatVersion = 2;

template <class FieldLike>
TableSpec table_of(const std::string& name, const std::string& title,
                   const std::vector<FieldLike>& fields) {
  return {name, title, {fields.begin(), fields.end()}};
}

/// /runs: one record a run.
inline TableSpec runs_table() {
  return table_of("runs", "instance x algorithm x options x repetition", run_columns());
}

/// /environments: session, name and value, as wide as they are.
inline TableSpec environments_table(std::size_t name_size, std::size_t value_size) {
  std::vector<Field> fields = {
      {"session", "1", "which process of the study", FieldType::int64, sizeof(std::int64_t), 0},
      {"name", "", "what is described", FieldType::text, std::max<std::size_t>(1, name_size), 0},
      {"value", "", "its value", FieldType::text, std::max<std::size_t>(1, value_size), 0}};
  pack_fields(fields);
  return table_of("environments", "machine, compiler, libraries and settings of every session",
                  fields);
}

}  // namespace ar3d
