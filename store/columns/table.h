#pragma once

#include <string>
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

}  // namespace ar3d
