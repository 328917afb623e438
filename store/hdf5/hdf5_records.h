#pragma once

// What writing and reading tables share.

#include <string>
#include <vector>

#include "ar3d/store/columns/field.h"
#include "ar3d/store/hdf5/hdf5_handle.h"

namespace ar3d::hdf5 {

enum class Place { file, memory };

/// The type of a field, little-endian and ASCII in a file.
Hdf5Handle field_type(const Field& field, Place place);
/// The compound type of packed records.
Hdf5Handle record_type(const std::vector<Field>& fields, Place place);

/// The records [first, first + count) of a dataset as a selection in the file, and its counterpart
/// in memory.
struct Slab {
  Hdf5Handle file;
  Hdf5Handle memory;
};
Slab select_records(hid_t dataset, hsize_t first, hsize_t count);

/// Opens a dataset whose bytes are all in this very file and that only needs deflate to be read.
/// @throws Hdf5Error if it is missing, lies behind a soft or external link, has external or virtual
/// storage, other filters, or chunks of more than 64 MiB.
Hdf5Handle open_own_dataset(hid_t file, const std::string& name);

}  // namespace ar3d::hdf5
