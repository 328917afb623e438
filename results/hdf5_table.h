#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "ar3d/results/field.h"
#include "ar3d/results/hdf5_handle.h"

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

/// Creates the table and fills it; `store` writes record i (zeroed before) to the given bytes.
/// Memory: a few hundred records. @throws Hdf5Error
void write_table(hid_t file, const TableSpec& table, std::size_t count,
                 const std::function<void(std::size_t i, char* record)>& store);

/// Calls `load` with every record in order, laid out as table.fields. Fields are found by name,
/// numbers are converted; fields of the file that are not asked for are ignored.
/// @throws Hdf5Error if the table or a field is missing or a field is of another class.
void read_table(hid_t file, const TableSpec& table,
                const std::function<void(const char* record)>& load);

/// Size in bytes of a text field of a table in the file.
std::size_t stored_text_size(hid_t file, const std::string& table, const std::string& field);

}  // namespace ar3d
