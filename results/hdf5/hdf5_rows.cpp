#include "ar3d/results/hdf5/hdf5_rows.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ar3d {
namespace {

constexpr std::uint64_t kRowsAtOnce = 4096;
constexpr std::uint64_t kLargestRatio = 1100;  // deflate packs at most about 1032 to 1

using Shape = std::array<hsize_t, 2>;

int rank_of(unsigned columns) { return columns == 1 ? 1 : 2; }

/// Moves `count` rows from row `first` on between the dataset and `numbers`.
template <class Transfer>
void transfer_rows(hid_t dataset, std::uint64_t first, std::uint64_t count, unsigned columns,
                   Transfer transfer) {
  const Shape start{first, 0};
  const Shape shape{count, columns};
  const Hdf5Handle in_file(H5Dget_space(dataset), H5Sclose, "read a dataset's shape");
  const Hdf5Handle in_memory(H5Screate_simple(rank_of(columns), shape.data(), nullptr), H5Sclose,
                             "shape a block");
  hdf5_checked(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start.data(), nullptr,
                                   shape.data(), nullptr),
               "select rows");
  transfer(in_memory.get(), in_file.get());
}

Hdf5Handle open_dataset(hid_t file, const std::string& name) {
  if (H5Lexists(file, name.c_str(), H5P_DEFAULT) <= 0) throw Hdf5Error("/" + name + " is missing");
  return {H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "open a dataset"};
}

}  // namespace

void write_rows(hid_t file, const std::string& name, std::uint64_t rows, unsigned columns,
                const std::function<void(std::int64_t* row)>& next) {
  const Shape shape{rows, columns};
  const Hdf5Handle space(H5Screate_simple(rank_of(columns), shape.data(), nullptr), H5Sclose,
                         "shape a dataset");
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "create properties");
  hdf5_checked(H5Pset_create_intermediate_group(links.get(), 1), "set properties");
  const Hdf5Handle dataset(H5Dcreate2(file, name.c_str(), H5T_STD_I64LE, space.get(), links.get(),
                                      H5P_DEFAULT, H5P_DEFAULT),
                           H5Dclose, "create a dataset");
  std::vector<std::int64_t> numbers;
  for (std::uint64_t first = 0; first < rows; first += kRowsAtOnce) {
    const std::uint64_t count = std::min(kRowsAtOnce, rows - first);
    numbers.resize(count * columns);
    for (std::uint64_t i = 0; i < count; ++i) next(&numbers[i * columns]);
    transfer_rows(dataset.get(), first, count, columns, [&](hid_t in_memory, hid_t in_file) {
      hdf5_checked(H5Dwrite(dataset.get(), H5T_NATIVE_INT64, in_memory, in_file, H5P_DEFAULT,
                            numbers.data()),
                   "write rows");
    });
  }
}

std::uint64_t count_rows(hid_t file, const std::string& name, unsigned columns,
                         std::uint64_t file_bytes) {
  const Hdf5Handle dataset = open_dataset(file, name);
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose, "read a dataset's type");
  const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose, "read a dataset's shape");
  if (H5Tget_class(type.get()) != H5T_INTEGER) throw Hdf5Error("/" + name + " holds no integers");
  if (H5Tget_size(type.get()) > 8 ||
      (H5Tget_size(type.get()) == 8 && H5Tget_sign(type.get()) == H5T_SGN_NONE)) {
    throw Hdf5Error("/" + name + " holds integers that may not fit 64 bits with sign");
  }
  Shape shape{0, 1};
  if (H5Sget_simple_extent_ndims(space.get()) != rank_of(columns) ||
      H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr) < 0 || shape[1] != columns) {
    throw Hdf5Error("/" + name + " has not the shape rows x " + std::to_string(columns));
  }
  if (shape[0] / kLargestRatio > file_bytes) {
    throw Hdf5Error("/" + name + " claims " + std::to_string(shape[0]) +
                    " rows, more than the file can hold");
  }
  return shape[0];
}

void read_rows(hid_t file, const std::string& name, std::uint64_t rows, unsigned columns,
               const std::function<void(const std::int64_t* row)>& visit) {
  const Hdf5Handle dataset = open_dataset(file, name);
  std::vector<std::int64_t> numbers;
  for (std::uint64_t first = 0; first < rows; first += kRowsAtOnce) {
    const std::uint64_t count = std::min(kRowsAtOnce, rows - first);
    numbers.resize(count * columns);
    transfer_rows(dataset.get(), first, count, columns, [&](hid_t in_memory, hid_t in_file) {
      hdf5_checked(
          H5Dread(dataset.get(), H5T_NATIVE_INT64, in_memory, in_file, H5P_DEFAULT, numbers.data()),
          "read rows");
    });
    for (std::uint64_t i = 0; i < count; ++i) visit(&numbers[i * columns]);
  }
}

}  // namespace ar3d
