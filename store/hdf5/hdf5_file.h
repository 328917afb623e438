#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/base/descriptor.h"
#include "ar3d/store/hdf5/hdf5_handle.h"

namespace ar3d {

/// An HDF5 file that goes into an open, empty, readable and writable file. HDF5 never sees a write
/// fail: it would not give the file up. The first failure is kept here instead, what comes after it
/// is dropped.
class Hdf5Output {
 public:
  /// @param descriptor  is duplicated.
  explicit Hdf5Output(int descriptor);
  hid_t get() const { return file_->get(); }
  /// Ends the file. @return 0, or the errno of the first write that failed.
  int close();

  /// Where the bytes go.
  struct Sink {
    Descriptor descriptor;
    int error = 0;
  };

 private:
  std::shared_ptr<Sink> sink_;
  std::optional<Hdf5Handle> file_;
};

/// An HDF5 file that is built in memory, so that a full disk meets one checked write() of its image
/// and never HDF5's caches.
Hdf5Handle create_hdf5_in_memory();

/// The bytes of that file.
std::vector<char> hdf5_image(hid_t file);

/// Opens a regular file to read that begins as HDF5 files do. @throws InputError naming the path:
/// the system's reason if it cannot be read, or that it is not HDF5.
Descriptor open_hdf5_file(const std::string& path);

}  // namespace ar3d
