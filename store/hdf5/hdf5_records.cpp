#include "ar3d/store/hdf5/hdf5_records.h"

#include <fmt/format.h>

namespace ar3d::hdf5 {
namespace {

constexpr hsize_t kLargestChunk = hsize_t{1} << 26;  // bytes
constexpr int kMostDimensions = 2;

hid_t number_type(FieldType type, Place place) {
  switch (type) {
    case FieldType::int64:
      return place == Place::file ? H5T_STD_I64LE : H5T_NATIVE_INT64;
    case FieldType::uint64:
      return place == Place::file ? H5T_STD_U64LE : H5T_NATIVE_UINT64;
    default:
      return place == Place::file ? H5T_IEEE_F64LE : H5T_NATIVE_DOUBLE;
  }
}

void require_hard_link(hid_t file, const std::string& name) {
  if (hdf5_checked(H5Lexists(file, name.c_str(), H5P_DEFAULT), "look for a dataset") == 0) {
    throw Hdf5Error(fmt::format("/{} is missing", name));
  }
  H5L_info_t link{};
  hdf5_checked(H5Lget_info(file, name.c_str(), &link, H5P_DEFAULT), "look at a link");
  if (link.type != H5L_TYPE_HARD) throw Hdf5Error(fmt::format("/{} is a link elsewhere", name));
}

void require_plain_filters(hid_t properties, const std::string& name) {
  const int filters = hdf5_checked(H5Pget_nfilters(properties), "count filters");
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(properties, static_cast<unsigned>(i), &flags,
                                               &values, nullptr, 0, nullptr, nullptr);
    if (filter != H5Z_FILTER_DEFLATE) {
      throw Hdf5Error(fmt::format("/{} is packed with something else than deflate", name));
    }
  }
}

void require_small_chunks(hid_t dataset, hid_t properties, const std::string& name) {
  hsize_t chunk[kMostDimensions] = {1, 1};
  const int dimensions =
      hdf5_checked(H5Pget_chunk(properties, kMostDimensions, chunk), "size chunks");
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, "read a dataset's type");
  const std::size_t size = H5Tget_size(type.get());
  if (dimensions > kMostDimensions || size == 0 || chunk[0] > kLargestChunk ||
      chunk[1] > kLargestChunk || chunk[0] * chunk[1] > kLargestChunk / size) {
    throw Hdf5Error(fmt::format("/{} has chunks of more than {} bytes", name, kLargestChunk));
  }
}

}  // namespace

Hdf5Handle field_type(const Field& field, Place place) {
  if (field.type == FieldType::text) return text_type(field.size, H5T_CSET_ASCII);
  return Hdf5Handle(H5Tcopy(number_type(field.type, place)), H5Tclose, "copy a type");
}

Hdf5Handle record_type(const std::vector<Field>& fields, Place place) {
  Hdf5Handle record(H5Tcreate(H5T_COMPOUND, record_size(fields)), H5Tclose, "create a record type");
  for (const Field& field : fields) {
    const Hdf5Handle type = field_type(field, place);
    hdf5_checked(H5Tinsert(record.get(), field.name.c_str(), field.offset, type.get()),
                 "add a field to a record type");
  }
  return record;
}

Slab select_records(hid_t dataset, hsize_t first, hsize_t count) {
  Slab slab{{H5Dget_space(dataset), H5Sclose, "read a table's shape"},
            {H5Screate_simple(1, &count, nullptr), H5Sclose, "create a buffer's shape"}};
  hdf5_checked(
      H5Sselect_hyperslab(slab.file.get(), H5S_SELECT_SET, &first, nullptr, &count, nullptr),
      "select records");
  return slab;
}

Hdf5Handle open_own_dataset(hid_t file, const std::string& name) {
  require_hard_link(file, name);
  Hdf5Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "open a dataset");
  const Hdf5Handle properties(H5Dget_create_plist(dataset.get()), H5Pclose,
                              "read how a dataset is stored");
  const H5D_layout_t layout = H5Pget_layout(properties.get());
  if (layout == H5D_VIRTUAL || layout == H5D_LAYOUT_ERROR) {
    throw Hdf5Error(fmt::format("/{} is a view of other datasets", name));
  }
  if (hdf5_checked(H5Pget_external_count(properties.get()), "count external files") != 0) {
    throw Hdf5Error(fmt::format("/{} has its bytes in another file", name));
  }
  require_plain_filters(properties.get(), name);
  if (layout == H5D_CHUNKED) require_small_chunks(dataset.get(), properties.get(), name);
  return dataset;
}

}  // namespace ar3d::hdf5
