#include "ar3d/store/hdf5/hdf5_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>

#include "ar3d/base/error.h"

namespace ar3d {

Hdf5Handle create_hdf5_in_memory() {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "create properties");
  constexpr std::size_t kGrowth = std::size_t{1} << 20;
  hdf5_checked(H5Pset_fapl_core(access.get(), kGrowth, false), "choose the memory driver");
  return {H5Fcreate("memory.h5", H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose,
          "create a file in memory"};
}

std::vector<char> hdf5_image(hid_t file) {
  hdf5_checked(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush");
  const ssize_t size = hdf5_checked(H5Fget_file_image(file, nullptr, 0), "size the file's image");
  std::vector<char> image(static_cast<std::size_t>(size));
  hdf5_checked(H5Fget_file_image(file, image.data(), image.size()), "take the file's image");
  return image;
}

Descriptor open_hdf5_file(const std::string& path) {
  const auto refuse = [&](int reason) {
    throw InputError(fmt::format("cannot read {}: {}", path, std::strerror(reason)));
  };
  Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) refuse(errno);
  struct stat status {};
  if (fstat(file.get(), &status) != 0) refuse(errno);
  if (S_ISDIR(status.st_mode)) refuse(EISDIR);
  constexpr std::string_view kSignature("\211HDF\r\n\032\n", 8);
  char start[kSignature.size()] = {};
  if (!S_ISREG(status.st_mode) || pread(file.get(), start, sizeof(start), 0) != sizeof(start) ||
      std::string_view(start, sizeof(start)) != kSignature) {
    throw InputError(fmt::format("{} is not an HDF5 file", path));
  }
  return file;
}

}  // namespace ar3d
