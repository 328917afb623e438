#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "ar3d/base/error.h"
#include "ar3d/store/hdf5/hdf5_records.h"
#include "ar3d/store/hdf5/hdf5_table.h"

namespace ar3d {
namespace {

using hdf5::Place;

constexpr hsize_t kRecordsAtOnce = 512;
constexpr hsize_t kLargestRatio = 1100;        // deflate packs at most about 1032 to 1
constexpr std::size_t kLargestText = 1 << 20;  // bytes of a field whose size the file decides

hsize_t record_count(hid_t dataset, const std::string& name, std::uint64_t file_bytes) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "read a table's shape");
  if (H5Sget_simple_extent_ndims(space.get()) != 1) {
    throw Hdf5Error(fmt::format("/{} is not a one-dimensional table", name));
  }
  hsize_t count = 0;
  hdf5_checked(H5Sget_simple_extent_dims(space.get(), &count, nullptr), "read a table's length");
  if (count / kLargestRatio > file_bytes) {
    throw Hdf5Error(fmt::format("/{} claims {} records, more than the file can hold", name, count));
  }
  return count;
}

Hdf5Handle type_of(hid_t dataset, const std::string& name) {
  Hdf5Handle type(H5Dget_type(dataset), H5Tclose, "read a table's type");
  if (H5Tget_class(type.get()) != H5T_COMPOUND) {
    throw Hdf5Error(fmt::format("/{} is not a table of records", name));
  }
  return type;
}

// The type of the field of that name, if the file has it.
std::optional<Hdf5Handle> member_type(hid_t record, const std::string& name) {
  const int index = H5Tget_member_index(record, name.c_str());
  H5Eclear2(H5E_DEFAULT);
  if (index < 0) return std::nullopt;
  return Hdf5Handle(H5Tget_member_type(record, static_cast<unsigned>(index)), H5Tclose,
                    "read a field's type");
}

// Of the wanted fields those that the file has, under their names there.
std::vector<Field> stored_fields(hid_t dataset, const TableSpec& table, FieldNames names) {
  const Hdf5Handle record = type_of(dataset, table.name);
  std::vector<Field> found;
  for (Field field : table.fields) {
    if (names == FieldNames::former && !field.former_name.empty()) field.name = field.former_name;
    const std::optional<Hdf5Handle> type = member_type(record.get(), field.name);
    if (!type && field.required) {
      throw Hdf5Error(fmt::format("/{} has no field '{}'", table.name, field.name));
    }
    if (!type) continue;
    if (H5Tequal(type->get(), hdf5::field_type(field, Place::file).get()) <= 0) {
      throw Hdf5Error(fmt::format("/{}: field '{}' has another type", table.name, field.name));
    }
    found.push_back(std::move(field));
  }
  if (found.empty()) throw Hdf5Error(fmt::format("/{} has none of its fields", table.name));
  return found;
}

std::vector<Field> packed(std::vector<Field> fields) {
  pack_fields(fields);
  return fields;
}

std::vector<char> record_without_values(const std::vector<Field>& fields) {
  std::vector<char> record(record_size(fields));
  for (const Field& field : fields) store_missing(field, record.data() + field.offset);
  return record;
}

}  // namespace

TableReader::TableReader(hid_t file, const TableSpec& table, std::uint64_t file_bytes,
                         FieldNames names)
    : dataset_(hdf5::open_own_dataset(file, table.name)),
      wanted_(stored_fields(dataset_.get(), table, names)),
      found_(packed(wanted_)),
      missing_(record_without_values(table.fields)),
      type_(hdf5::record_type(found_, Place::memory)),
      as_it_is_(found_.size() == table.fields.size()),
      size_(record_count(dataset_.get(), table.name, file_bytes)) {}

const char* TableReader::read(std::size_t i) {
  expect(i < size_, "a table has that record");
  const std::size_t size = record_size(found_);
  if (i < first_ || i >= first_ + count_) {
    count_ = 0;
    first_ = i / kRecordsAtOnce * kRecordsAtOnce;
    const std::size_t count = std::min<std::size_t>(kRecordsAtOnce, size_ - first_);
    buffer_.resize(count * size);
    const hdf5::Slab slab = hdf5::select_records(dataset_.get(), first_, count);
    hdf5_checked(H5Dread(dataset_.get(), type_.get(), slab.memory.get(), slab.file.get(),
                         H5P_DEFAULT, buffer_.data()),
                 "read records");
    count_ = count;
  }
  const char* found = buffer_.data() + (i - first_) * size;
  if (as_it_is_) return found;
  record_ = missing_;
  for (std::size_t f = 0; f < found_.size(); ++f) {
    std::memcpy(record_.data() + wanted_[f].offset, found + found_[f].offset, found_[f].size);
  }
  return record_.data();
}

void read_table(hid_t file, const TableSpec& table, std::uint64_t file_bytes,
                const std::function<void(const char* record)>& load) {
  TableReader reader(file, table, file_bytes);
  for (std::size_t i = 0; i < reader.size(); ++i) load(reader.read(i));
}

bool has_table(hid_t file, const std::string& name) {
  return hdf5_checked(H5Lexists(file, name.c_str(), H5P_DEFAULT), "look for a table") > 0;
}

std::size_t stored_text_size(hid_t file, const std::string& table, const std::string& field) {
  const Hdf5Handle dataset = hdf5::open_own_dataset(file, table);
  const std::optional<Hdf5Handle> type = member_type(type_of(dataset.get(), table).get(), field);
  if (!type) throw Hdf5Error(fmt::format("/{} has no field '{}'", table, field));
  const std::size_t size = H5Tget_size(type->get());
  if (size == 0 || size > kLargestText) {
    throw Hdf5Error(fmt::format("/{}: field '{}' has {} bytes", table, field, size));
  }
  return size;
}

}  // namespace ar3d
