#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "ar3d/store/columns/row_key.h"
#include "ar3d/store/columns/table.h"
#include "ar3d/store/study_identity.h"

namespace ar3d {

/// A table that follows from the rows: for every value of the `key` fields one record, made of
/// `fields` of the first row that has it. Both are places in the rows' fields.
struct ExtractSpec {
  std::string name;
  std::string title;
  std::vector<std::size_t> fields;
  std::vector<std::size_t> key;
};

/// What the rows of a study are made of. Journals and results files store any list of fields and
/// know none by name; those whose meaning they need are told here, by their places.
struct RowFormat {
  TableSpec rows;
  std::size_t key = 0;      ///< 32 hexadecimal digits that tell rows apart; the first field
  std::size_t status = 0;   ///< a text; rows with another one than "ok" are counted
  std::size_t session = 0;  ///< int64: which session made the row
  ExtractSpec extract;
  std::vector<TableSpec> tables;  ///< small tables that stand beside the rows

  /// Results files of version 2: fields that only they have, behind `rows.fields` in a record of
  /// theirs, and what is to be kept of every such record.
  std::vector<Field> former_fields;
  std::function<void(const char* record, StudyIdentity& identity)> keep_of_former;

  std::size_t record_size() const { return ar3d::record_size(rows.fields); }
};

/// The key of a record. @throws InputError as parse_row_key.
RowKey key_of_record(const RowFormat& format, const char* record);

/// Rows that are made or fetched one at a time; `read` writes record i.
struct RecordSource {
  std::size_t count = 0;
  std::function<void(std::size_t i, char* record)> read;
};

}  // namespace ar3d
