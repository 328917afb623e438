#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/store/columns/table.h"
#include "ar3d/store/hdf5/hdf5_handle.h"

namespace ar3d {

/// Says how many records a file has at most for each of its bytes: deflate packs at most about 1032
/// to 1.
inline constexpr std::uint64_t kMostRecordsPerByte = 1100;

// A StoredTable in an HDF5 file is a one-dimensional dataset of a compound type, chunked and
// compressed, with the attributes by which PyTables (hence pandas.read_hdf) knows its tables, and
// `<column>.unit` and `<column>.meaning` for every column.

/// Opens a dataset whose bytes are all in this very file and that only needs deflate to be read.
/// @throws Hdf5Error if it is missing, lies behind a soft or external link, has external or virtual
/// storage, other filters, or chunks of more than 64 MiB.
Hdf5Handle open_own_dataset(hid_t file, const std::string& name);

/// Represents a new table that grows record by record. Memory: a few hundred records.
class TableWriter {
 public:
  /// @throws Hdf5Error
  TableWriter(hid_t file, const StoredTable& table);
  /// Copies a packed record. @throws Hdf5Error
  void append(const char* record);
  /// Writes what is buffered and the number of records. Once, at the end. @throws Hdf5Error
  void finish();

 private:
  void flush();

  Hdf5Handle type_;
  Hdf5Handle dataset_;
  std::size_t record_size_;
  std::size_t written_ = 0;
  std::vector<char> buffer_;
};

/// Writes a whole table. @throws Hdf5Error
void write_table(hid_t file, const StoredTable& table);

/// Represents a table of an open file, read by record number. Memory: a chunk of records.
class TableReader {
 public:
  /// Finds columns by name; columns of the file that are not asked for are ignored, those that
  /// are not in the file are missing in every record.
  /// @throws Hdf5Error if the table or a required column is missing, a column is not exactly of its
  /// type, or the table is not stored as this program stores tables: chunked, deflated or plain, in
  /// the file itself, and with no more records than `file_bytes` can hold.
  TableReader(hid_t file, const StoredTable& table, std::uint64_t file_bytes);
  std::size_t size() const { return size_; }
  /// Returns record i, laid out as table.columns; valid until the next call. Cheap if i is near the
  /// one before. @throws Hdf5Error
  const char* read(std::size_t i);

 private:
  Hdf5Handle dataset_;
  std::vector<Column> wanted_;  // those that the file has, at their offsets in a record
  std::vector<Column> found_;   // the same, packed
  std::vector<char> missing_;   // a record without any value
  Hdf5Handle type_;             // of found_
  bool as_it_is_;               // the file has all columns that are asked for
  std::size_t size_ = 0;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::vector<char> buffer_;
  std::vector<char> record_;
};

/// Reads a whole table. @throws Hdf5Error as TableReader.
StoredTable read_table(hid_t file, const StoredTable& table, std::uint64_t file_bytes);

/// Returns true if there is a table of that name. @throws Hdf5Error if it is a link elsewhere.
bool has_table(hid_t file, const std::string& name);

/// Returns the size in bytes of a text column of a table in the file.
std::size_t stored_text_size(hid_t file, const std::string& table, const std::string& field);

}  // namespace ar3d
