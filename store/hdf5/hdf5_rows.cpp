#include "ar3d/store/hdf5/hdf5_rows.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ar3d {
namespace {

constexpr std::uint64_t kRowsAtOnce = 4096;

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

}  // namespace ar3d
