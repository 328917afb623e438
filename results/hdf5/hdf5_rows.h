#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "ar3d/results/hdf5/hdf5_handle.h"

namespace ar3d {

/// Creates the dataset `name`: `rows` rows of `columns` 64-bit integers, one-dimensional for one
/// column; `next` fills one row after the other. Memory: a few thousand rows. @throws Hdf5Error
void write_rows(hid_t file, const std::string& name, std::uint64_t rows, unsigned columns,
                const std::function<void(std::int64_t* row)>& next);

/// Number of rows. @throws Hdf5Error if the dataset is missing, holds no integers, has not that
/// many columns, or claims more numbers than a file of `file_bytes` bytes can hold.
std::uint64_t count_rows(hid_t file, const std::string& name, unsigned columns,
                         std::uint64_t file_bytes);

/// Calls `visit` with every row in order. @throws Hdf5Error
void read_rows(hid_t file, const std::string& name, std::uint64_t rows, unsigned columns,
               const std::function<void(const std::int64_t* row)>& visit);

}  // namespace ar3d
