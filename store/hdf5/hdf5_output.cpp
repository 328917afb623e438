// A driver of HDF5's virtual file layer that keeps write errors to itself. All but writing is
// HDF5's own driver of plain files, which here works on a descriptor that is open already.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "ar3d/store/hdf5/hdf5_table.h"

namespace ar3d {
namespace {

constexpr const char* kPath = "/dev/null";  // for the plain driver, which writes elsewhere

thread_local int t_descriptor = -1;  // where the bytes of this thread's file go
thread_local int t_error = 0;        // errno of the first write that failed

const H5FD_class_t& plain_driver() {
  static const H5FD_class_t driver = [] {
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "create properties");
    hdf5_checked(H5Pset_fapl_sec2(access.get()), "choose a file driver");
    H5FD_t* const file = H5FDopen(kPath, H5F_ACC_RDONLY, access.get(), HADDR_UNDEF);
    if (file == nullptr) throw_hdf5_error("look at a file driver");
    const H5FD_class_t plain = *file->cls;
    H5FDclose(file);
    return plain;
  }();
  return driver;
}

H5FD_t* open_file(const char*, unsigned flags, hid_t properties, haddr_t largest) {
  H5FD_t* const file = plain_driver().open(kPath, flags, properties, largest);
  void* handle = nullptr;  // leads to the descriptor that the plain driver reads and writes
  if (file == nullptr) return nullptr;
  if (plain_driver().get_handle(file, properties, &handle) >= 0 &&
      dup3(t_descriptor, *static_cast<int*>(handle), O_CLOEXEC) >= 0) {
    return file;
  }
  plain_driver().close(file);
  return nullptr;
}

int compare_files(const H5FD_t* a, const H5FD_t* b) { return a < b ? -1 : a > b ? 1 : 0; }

// Runs a step of the plain driver that may fail for want of room.
template <class Step>
herr_t with_error_kept(const Step& step) {
  if (t_error != 0) return 0;
  errno = 0;
  if (step() < 0) t_error = errno != 0 ? errno : EIO;
  return 0;
}

herr_t write_bytes(H5FD_t* file, H5FD_mem_t type, hid_t properties, haddr_t address,
                   std::size_t size, const void* from) {
  return with_error_kept(
      [&] { return plain_driver().write(file, type, properties, address, size, from); });
}

herr_t truncate_file(H5FD_t* file, hid_t properties, hbool_t closing) {
  return with_error_kept([&] { return plain_driver().truncate(file, properties, closing); });
}

hid_t checked_driver() {
  static const H5FD_class_t driver = [] {
    H5FD_class_t made = plain_driver();
    made.name = "ar3d_checked";
    made.open = open_file;
    made.cmp = compare_files;
    made.write = write_bytes;
    made.truncate = truncate_file;
    made.lock = nullptr;  // the file is locked, or no other process can know it
    made.unlock = nullptr;
    return made;
  }();
  static const hid_t id = hdf5_checked(H5FDregister(&driver), "register a file driver");
  return id;
}

}  // namespace

int write_hdf5_file(int descriptor, const std::function<void(hid_t file)>& fill) {
  t_descriptor = descriptor;
  t_error = 0;
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "create properties");
  hdf5_checked(H5Pset_driver(access.get(), checked_driver(), nullptr), "choose the file driver");
  {
    const Hdf5Handle file(H5Fcreate(kPath, H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose,
                          "create a file");
    fill(file.get());
    hdf5_checked(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), "flush");
  }  // closing writes, too
  return t_error;
}

}  // namespace ar3d
