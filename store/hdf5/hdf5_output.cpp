// A driver of HDF5's virtual file layer that keeps write errors to itself.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <new>

#include "ar3d/base/system_calls.h"
#include "ar3d/store/hdf5/hdf5_handle.h"

namespace ar3d {
namespace {

using Sink = Hdf5Output::Sink;

// HDF5 keeps it from open to close and takes it for an H5FD_t.
struct OpenFile {
  H5FD_t base{};  // first: HDF5's pointer to it is a pointer to all
  std::shared_ptr<Sink> sink;
  haddr_t end_of_address = 0;
  haddr_t end_of_file = 0;
};

OpenFile& self(H5FD_t* file) { return *reinterpret_cast<OpenFile*>(file); }
const OpenFile& self(const H5FD_t* file) { return *reinterpret_cast<const OpenFile*>(file); }

// The properties carry the address of the sink's owner, which lives during the call of H5Fcreate.
H5FD_t* open_file(const char*, unsigned, hid_t properties, haddr_t) {
  const void* owner = H5Pget_driver_info(properties);
  if (owner == nullptr) return nullptr;
  auto* file = new (std::nothrow) OpenFile;
  if (file == nullptr) return nullptr;
  file->sink = **static_cast<const std::shared_ptr<Sink>* const*>(owner);
  return &file->base;
}

herr_t close_file(H5FD_t* file) {
  delete &self(file);
  return 0;
}

int compare_files(const H5FD_t* a, const H5FD_t* b) { return a < b ? -1 : a > b ? 1 : 0; }

// As HDF5's own driver of plain files.
herr_t query(const H5FD_t*, unsigned long* flags) {
  if (flags != nullptr) {
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA;
  }
  return 0;
}

haddr_t end_of_address(const H5FD_t* file, H5FD_mem_t) { return self(file).end_of_address; }

herr_t set_end_of_address(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  self(file).end_of_address = address;
  return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) { return self(file).end_of_file; }

// What lies behind the end of the file is zero.
herr_t read_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* to) {
  char* const bytes = static_cast<char*>(to);
  const std::size_t got = read_whole(self(file).sink->descriptor.get(), {bytes, size}, address);
  if (got < size && errno != 0) return -1;
  std::memset(bytes + got, 0, size - got);
  return 0;
}

herr_t write_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size,
                   const void* from) {
  Sink& sink = *self(file).sink;
  self(file).end_of_file = std::max(self(file).end_of_file, address + size);
  const std::span<const char> bytes{static_cast<const char*>(from), size};
  if (sink.error == 0 && write_whole(sink.descriptor.get(), bytes, address) < size) {
    sink.error = errno;
  }
  return 0;
}

herr_t truncate_file(H5FD_t* file, hid_t, hbool_t) {
  OpenFile& open = self(file);
  if (open.end_of_address == open.end_of_file) return 0;
  Sink& sink = *open.sink;
  const auto size = static_cast<off_t>(open.end_of_address);
  if (sink.error == 0 && ftruncate(sink.descriptor.get(), size) != 0) sink.error = errno;
  open.end_of_file = open.end_of_address;
  return 0;
}

hid_t checked_driver() {
  static const H5FD_class_t driver = [] {
    H5FD_class_t made{};
#ifdef H5FD_CLASS_VERSION
    made.version = H5FD_CLASS_VERSION;
    made.value = static_cast<H5FD_class_value_t>(512);
#endif
    made.name = "ar3d_checked";
    made.maxaddr = static_cast<haddr_t>(1) << 62;
    made.fc_degree = H5F_CLOSE_WEAK;
    made.fapl_size = sizeof(const void*);
    made.open = open_file;
    made.close = close_file;
    made.cmp = compare_files;
    made.query = query;
    made.get_eoa = end_of_address;
    made.set_eoa = set_end_of_address;
    made.get_eof = end_of_file;
    made.read = read_bytes;
    made.write = write_bytes;
    made.truncate = truncate_file;
    constexpr H5FD_mem_t kMap[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(kMap), std::end(kMap), made.fl_map);
    return made;
  }();
  static const hid_t id = hdf5_checked(H5FDregister(&driver), "register a file driver");
  return id;
}

}  // namespace

Hdf5Output::Hdf5Output(int descriptor) : sink_(std::make_shared<Sink>()) {
  sink_->descriptor = Descriptor(fcntl(descriptor, F_DUPFD_CLOEXEC, 0));
  if (sink_->descriptor.get() < 0) sink_->error = errno;
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "create properties");
  const std::shared_ptr<Sink>* owner = &sink_;
  hdf5_checked(H5Pset_driver(access.get(), checked_driver(), &owner), "choose the file driver");
  file_.emplace(H5Fcreate("checked.h5", H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose,
                "create a file");
}

int Hdf5Output::close() {
  if (file_) hdf5_checked(H5Fflush(file_->get(), H5F_SCOPE_GLOBAL), "flush");
  file_.reset();
  return sink_->error;
}

}  // namespace ar3d
