#include "ar3d/results/hdf5/hdf5_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "ar3d/model/error.h"

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

void require_hdf5_file(const std::string& path) {
  if (std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("cannot read {}: {}", path, std::strerror(EISDIR)));
  }
  errno = 0;
  std::ifstream probe(path, std::ios::binary);
  if (!probe) throw InputError(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  if (H5Fis_hdf5(path.c_str()) <= 0) {
    throw InputError(fmt::format("{} is not an HDF5 file", path));
  }
}

}  // namespace ar3d
