#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "ar3d/store/hdf5/hdf5_handle.h"

namespace ar3d {

/// Creates the dataset `name`: `rows` rows of `columns` 64-bit integers, one-dimensional for one
/// column; `next` fills one row after the other. Memory: a few thousand rows. @throws Hdf5Error
void write_rows(hid_t file, const std::string& name, std::uint64_t rows, unsigned columns,
                const std::function<void(std::int64_t* row)>& next);

}  // namespace ar3d
