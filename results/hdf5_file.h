#pragma once

#include <string>
#include <vector>

#include "ar3d/results/hdf5_handle.h"

namespace ar3d {

/// An HDF5 file that is built in memory, so that a full disk meets one checked write() of its image
/// and never HDF5's caches.
Hdf5Handle create_hdf5_in_memory();

/// The bytes of that file.
std::vector<char> hdf5_image(hid_t file);

/// @throws InputError naming the system's reason if the file cannot be read, or if it is not HDF5.
void require_hdf5_file(const std::string& path);

}  // namespace ar3d
