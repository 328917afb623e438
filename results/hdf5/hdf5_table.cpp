#include "ar3d/results/hdf5/hdf5_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "ar3d/model/error.h"

namespace ar3d {
namespace {

constexpr hsize_t kChunkRecords = 512;
constexpr unsigned kCompressionLevel = 1;

enum class Place { file, memory };

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

Hdf5Handle record_type(const std::vector<Field>& fields, Place place) {
  Hdf5Handle record(H5Tcreate(H5T_COMPOUND, record_size(fields)), H5Tclose, "create a record type");
  for (const Field& field : fields) {
    const Hdf5Handle type =
        field.type == FieldType::text
            ? text_type(field.size, H5T_CSET_ASCII)
            : Hdf5Handle(H5Tcopy(number_type(field.type, place)), H5Tclose, "copy a type");
    hdf5_checked(H5Tinsert(record.get(), field.name.c_str(), field.offset, type.get()),
                 "add a field to a record type");
  }
  return record;
}

Hdf5Handle create_dataset(hid_t file, const TableSpec& table) {
  const hsize_t size = 0;
  const hsize_t unlimited = H5S_UNLIMITED;
  const Hdf5Handle space(H5Screate_simple(1, &size, &unlimited), H5Sclose,
                         "create a table's shape");
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "create properties");
  hdf5_checked(H5Pset_chunk(properties.get(), 1, &kChunkRecords), "set chunks");
  hdf5_checked(H5Pset_deflate(properties.get(), kCompressionLevel), "set compression");
  hdf5_checked(H5Pset_obj_track_times(properties.get(), false), "leave time stamps out");
  const Hdf5Handle type = record_type(table.fields, Place::file);
  return {H5Dcreate2(file, table.name.c_str(), type.get(), space.get(), H5P_DEFAULT,
                     properties.get(), H5P_DEFAULT),
          H5Dclose, "create a table"};
}

void describe(hid_t dataset, const TableSpec& table) {
  write_attribute(dataset, "CLASS", "TABLE");
  write_attribute(dataset, "VERSION", "2.7");
  write_attribute(dataset, "TITLE", table.title);
  for (std::size_t i = 0; i < table.fields.size(); ++i) {
    write_attribute(dataset, fmt::format("FIELD_{}_NAME", i), table.fields[i].name);
  }
  for (const Field& field : table.fields) {
    write_attribute(dataset, field.name + ".unit", field.unit);
    write_attribute(dataset, field.name + ".meaning", field.meaning);
  }
}

// The records [first, first + count) of a dataset as a selection in the file, and its counterpart
// in memory.
struct Slab {
  Hdf5Handle file;
  Hdf5Handle memory;
};

Slab select(hid_t dataset, hsize_t first, hsize_t count) {
  Slab slab{{H5Dget_space(dataset), H5Sclose, "read a table's shape"},
            {H5Screate_simple(1, &count, nullptr), H5Sclose, "create a buffer's shape"}};
  hdf5_checked(
      H5Sselect_hyperslab(slab.file.get(), H5S_SELECT_SET, &first, nullptr, &count, nullptr),
      "select records");
  return slab;
}

hsize_t record_count(hid_t dataset, const std::string& name) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "read a table's shape");
  if (H5Sget_simple_extent_ndims(space.get()) != 1) {
    throw Hdf5Error(fmt::format("/{} is not a one-dimensional table", name));
  }
  hsize_t count = 0;
  hdf5_checked(H5Sget_simple_extent_dims(space.get(), &count, nullptr), "read a table's length");
  return count;
}

Hdf5Handle type_of(hid_t dataset, const std::string& name) {
  Hdf5Handle type(H5Dget_type(dataset), H5Tclose, "read a table's type");
  if (H5Tget_class(type.get()) != H5T_COMPOUND) {
    throw Hdf5Error(fmt::format("/{} is not a table of records", name));
  }
  return type;
}

Hdf5Handle open_table(hid_t file, const std::string& name) {
  if (hdf5_checked(H5Lexists(file, name.c_str(), H5P_DEFAULT), "look for a table") == 0) {
    throw Hdf5Error(fmt::format("/{} is missing", name));
  }
  return {H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "open a table"};
}

H5T_class_t expected_class(FieldType type) {
  if (type == FieldType::text) return H5T_STRING;
  return type == FieldType::float64 ? H5T_FLOAT : H5T_INTEGER;
}

unsigned field_index(hid_t type, const std::string& table, const std::string& field) {
  H5Eclear2(H5E_DEFAULT);
  const int index = H5Tget_member_index(type, field.c_str());
  if (index < 0) throw Hdf5Error(fmt::format("/{} has no field '{}'", table, field));
  return static_cast<unsigned>(index);
}

void require_fields(hid_t type, const TableSpec& table) {
  for (const Field& field : table.fields) {
    const unsigned index = field_index(type, table.name, field.name);
    const Hdf5Handle member(H5Tget_member_type(type, index), H5Tclose, "read a field's type");
    const bool fits = H5Tget_class(member.get()) == expected_class(field.type) &&
                      H5Tis_variable_str(member.get()) <= 0;
    if (!fits)
      throw Hdf5Error(fmt::format("/{}: field '{}' has another type", table.name, field.name));
  }
}

}  // namespace

TableWriter::TableWriter(hid_t file, const TableSpec& table)
    : type_(record_type(table.fields, Place::memory)),
      dataset_(create_dataset(file, table)),
      record_size_(record_size(table.fields)) {
  describe(dataset_.get(), table);
  buffer_.reserve(kChunkRecords * record_size_);
}

void TableWriter::append(const char* record) {
  buffer_.insert(buffer_.end(), record, record + record_size_);
  if (buffer_.size() == kChunkRecords * record_size_) flush();
}

void TableWriter::flush() {
  const hsize_t count = buffer_.size() / record_size_;
  if (count == 0) return;
  const hsize_t size = written_ + count;
  hdf5_checked(H5Dset_extent(dataset_.get(), &size), "extend a table");
  const Slab slab = select(dataset_.get(), written_, count);
  hdf5_checked(H5Dwrite(dataset_.get(), type_.get(), slab.memory.get(), slab.file.get(),
                        H5P_DEFAULT, buffer_.data()),
               "write records");
  written_ = size;
  buffer_.clear();
}

void TableWriter::finish() {
  flush();
  write_attribute(dataset_.get(), "NROWS", static_cast<long long>(written_));
}

void write_table(hid_t file, const TableSpec& table, std::size_t count,
                 const std::function<void(std::size_t i, char* record)>& store) {
  TableWriter writer(file, table);
  std::vector<char> record(record_size(table.fields));
  for (std::size_t i = 0; i < count; ++i) {
    std::fill(record.begin(), record.end(), '\0');
    store(i, record.data());
    writer.append(record.data());
  }
  writer.finish();
}

TableReader::TableReader(hid_t file, const TableSpec& table)
    : dataset_(open_table(file, table.name)),
      type_(record_type(table.fields, Place::memory)),
      record_size_(record_size(table.fields)) {
  require_fields(type_of(dataset_.get(), table.name).get(), table);
  size_ = record_count(dataset_.get(), table.name);
}

const char* TableReader::read(std::size_t i) {
  expect(i < size_, "a table has that record");
  if (i < first_ || i >= first_ + count_) {
    first_ = i / kChunkRecords * kChunkRecords;
    count_ = std::min<std::size_t>(kChunkRecords, size_ - first_);
    buffer_.resize(count_ * record_size_);
    const Slab slab = select(dataset_.get(), first_, count_);
    hdf5_checked(H5Dread(dataset_.get(), type_.get(), slab.memory.get(), slab.file.get(),
                         H5P_DEFAULT, buffer_.data()),
                 "read records");
  }
  return buffer_.data() + (i - first_) * record_size_;
}

void read_table(hid_t file, const TableSpec& table,
                const std::function<void(const char* record)>& load) {
  TableReader reader(file, table);
  for (std::size_t i = 0; i < reader.size(); ++i) load(reader.read(i));
}

std::size_t stored_text_size(hid_t file, const std::string& table, const std::string& field) {
  const Hdf5Handle dataset = open_table(file, table);
  const Hdf5Handle type = type_of(dataset.get(), table);
  const unsigned index = field_index(type.get(), table, field);
  const Hdf5Handle member(H5Tget_member_type(type.get(), index), H5Tclose, "read a field's type");
  return H5Tget_size(member.get());
}

}  // namespace ar3d
