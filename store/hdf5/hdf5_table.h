#pragma once

#include <hdf5.h>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/store/columns/table.h"

// The one place where HDF5's C API meets C++: every handle closes itself, every failure becomes an
// exception whose message is the innermost cause of HDF5's error stack.

namespace ar3d {

class Hdf5Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// @throws Hdf5Error "cannot <what>: <innermost cause>".
[[noreturn]] void throw_hdf5_error(const char* what);

/// Passes a result of the C API through. @throws Hdf5Error if it is negative.
template <class Result>
Result hdf5_checked(Result result, const char* what) {
  if (result < 0) throw_hdf5_error(what);
  return result;
}

/// Owns one HDF5 identifier.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  /// @throws Hdf5Error if id is negative, that is: if the call that made it failed.
  Hdf5Handle(hid_t id, Close close, const char* what)
      : id_(hdf5_checked(id, what)), close_(close) {}
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  hid_t get() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// Writes an attribute of an object: a UTF-8 string, or a 64-bit integer.
void write_attribute(hid_t object, const std::string& name, const std::string& value);
void write_attribute(hid_t object, const std::string& name, long long value);
/// @throws Hdf5Error if it is missing or of another type.
std::string read_text_attribute(hid_t object, const std::string& name);
long long read_integer_attribute(hid_t object, const std::string& name);

/// Returns a fixed-size, null-padded string type of `size` >= 1 bytes.
Hdf5Handle text_type(std::size_t size, H5T_cset_t charset);

/// Writes an HDF5 file into an open, empty, readable and writable one: calls fill(the file). HDF5
/// never sees a write fail: it would not give the file up. The first failure is kept here instead,
/// what comes after it is dropped.
/// @return 0, or the errno of the first write that failed.
int write_hdf5_file(int descriptor, const std::function<void(hid_t file)>& fill);

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

/// Returns the size in bytes of a text column of a table in the file.
std::size_t stored_text_size(hid_t file, const std::string& table, const std::string& field);

}  // namespace ar3d
