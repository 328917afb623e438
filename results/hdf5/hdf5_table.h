#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "ar3d/results/field.h"
#include "ar3d/results/hdf5/hdf5_handle.h"

namespace ar3d {

/// A table in an HDF5 file: a one-dimensional dataset of a compound type, chunked and compressed,
/// with the attributes by which PyTables (hence pandas.read_hdf) knows its tables, and
/// `<field>.unit` and
/// `<field>.meaning` for every field.
struct TableSpec {
  std::string name;
  std::string title;
  std::vector<Field> fields;  ///< packed
};

/// A new table that grows record by record. Memory: a few hundred records.
class TableWriter {
 public:
  /// @throws Hdf5Error
  TableWriter(hid_t file, const TableSpec& table);
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

/// Creates the table and fills it; `store` writes record i (zeroed before) to the given bytes.
/// @throws Hdf5Error
void write_table(hid_t file, const TableSpec& table, std::size_t count,
                 const std::function<void(std::size_t i, char* record)>& store);

/// A table of an open file, read by record number. Memory: a few hundred records.
class TableReader {
 public:
  /// Fields are found by name, numbers are converted; fields of the file that are not asked for are
  /// ignored. @throws Hdf5Error if the table or a field is missing or a field is of another class.
  TableReader(hid_t file, const TableSpec& table);
  std::size_t size() const { return size_; }
  /// Record i, laid out as table.fields; valid until the next call. Cheap if i is near the one
  /// before. @throws Hdf5Error
  const char* read(std::size_t i);

 private:
  Hdf5Handle dataset_;
  Hdf5Handle type_;
  std::size_t record_size_;
  std::size_t size_ = 0;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::vector<char> buffer_;
};

/// Calls `load` with every record in order. @throws Hdf5Error as TableReader.
void read_table(hid_t file, const TableSpec& table,
                const std::function<void(const char* record)>& load);

/// Size in bytes of a text field of a table in the file.
std::size_t stored_text_size(hid_t file, const std::string& table, const std::string& field);

}  // namespace ar3d
