// Tables in HDF5 files: written record by record, read by record number. What another program may
// have put into a file (links, filters, huge chunks, more records than it can hold) is refused.
#include "ar3d/store/hdf5/hdf5_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr hsize_t kChunkRecords = 512;  // written and read at once
constexpr unsigned kCompressionLevel = 1;
constexpr hsize_t kLargestChunk = hsize_t{1} << 26;  // bytes
constexpr int kMostDimensions = 2;

constexpr std::size_t kLargestField = 1 << 20;  // bytes of a field whose size the file decides

// Little-endian in a file.
hid_t number_type(ColumnType type, bool in_file) {
  switch (type) {
    case ColumnType::int64:
      return in_file ? H5T_STD_I64LE : H5T_NATIVE_INT64;
    case ColumnType::uint64:
      return in_file ? H5T_STD_U64LE : H5T_NATIVE_UINT64;
    default:
      return in_file ? H5T_IEEE_F64LE : H5T_NATIVE_DOUBLE;
  }
}

Hdf5Handle column_type(const Column& column, bool in_file) {
  if (column.type == ColumnType::text) return text_type(column.size, H5T_CSET_ASCII);
  return Hdf5Handle(H5Tcopy(number_type(column.type, in_file)), H5Tclose, "copy a type");
}

Hdf5Handle record_type(const std::vector<Column>& columns, bool in_file) {
  Hdf5Handle record(H5Tcreate(H5T_COMPOUND, record_size(columns)), H5Tclose,
                    "create a record type");
  for (const Column& column : columns) {
    const Hdf5Handle type = column_type(column, in_file);
    hdf5_checked(H5Tinsert(record.get(), column.name.c_str(), column.offset, type.get()),
                 "add a field to a record type");
  }
  return record;
}

// The records [first, first + count) of a dataset as a selection in the file, and its counterpart
// in memory.
std::pair<Hdf5Handle, Hdf5Handle> select_records(hid_t dataset, hsize_t first, hsize_t count) {
  std::pair<Hdf5Handle, Hdf5Handle> selected{
      Hdf5Handle(H5Dget_space(dataset), H5Sclose, "read a table's shape"),
      Hdf5Handle(H5Screate_simple(1, &count, nullptr), H5Sclose, "create a buffer's shape")};
  hdf5_checked(
      H5Sselect_hyperslab(selected.first.get(), H5S_SELECT_SET, &first, nullptr, &count, nullptr),
      "select records");
  return selected;
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

Hdf5Handle create_dataset(hid_t file, const StoredTable& table) {
  const hsize_t size = 0;
  const hsize_t unlimited = H5S_UNLIMITED;
  const Hdf5Handle space(H5Screate_simple(1, &size, &unlimited), H5Sclose,
                         "create a table's shape");
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "create properties");
  hdf5_checked(H5Pset_chunk(properties.get(), 1, &kChunkRecords), "set chunks");
  hdf5_checked(H5Pset_deflate(properties.get(), kCompressionLevel), "set compression");
  hdf5_checked(H5Pset_obj_track_times(properties.get(), false), "leave time stamps out");
  const Hdf5Handle type = record_type(table.columns, true);
  return {H5Dcreate2(file, table.name.c_str(), type.get(), space.get(), H5P_DEFAULT,
                     properties.get(), H5P_DEFAULT),
          H5Dclose, "create a table"};
}

void describe(hid_t dataset, const StoredTable& table) {
  write_attribute(dataset, "CLASS", "TABLE");
  write_attribute(dataset, "VERSION", "2.7");
  write_attribute(dataset, "TITLE", table.title);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    write_attribute(dataset, fmt::format("FIELD_{}_NAME", i), table.columns[i].name);
  }
  for (const Column& column : table.columns) {
    write_attribute(dataset, column.name + ".unit", column.unit);
    write_attribute(dataset, column.name + ".meaning", column.meaning);
  }
}

hsize_t record_count(hid_t dataset, const std::string& name, std::uint64_t file_bytes) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "read a table's shape");
  if (H5Sget_simple_extent_ndims(space.get()) != 1) {
    throw Hdf5Error(fmt::format("/{} is not a one-dimensional table", name));
  }
  hsize_t count = 0;
  hdf5_checked(H5Sget_simple_extent_dims(space.get(), &count, nullptr), "read a table's length");
  if (count / kMostRecordsPerByte > file_bytes) {
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

// Of the wanted columns those that the file has.
std::vector<Column> stored_columns(hid_t dataset, const StoredTable& table) {
  const Hdf5Handle record = type_of(dataset, table.name);
  std::vector<Column> found;
  for (Column column : table.columns) {
    const std::optional<Hdf5Handle> type = member_type(record.get(), column.name);
    if (!type && column.required) {
      throw Hdf5Error(fmt::format("/{} has no field '{}'", table.name, column.name));
    }
    if (!type) continue;
    if (H5Tequal(type->get(), column_type(column, true).get()) <= 0) {
      throw Hdf5Error(fmt::format("/{}: field '{}' has another type", table.name, column.name));
    }
    found.push_back(std::move(column));
  }
  if (found.empty()) throw Hdf5Error(fmt::format("/{} has none of its fields", table.name));
  return found;
}

std::vector<Column> packed(std::vector<Column> columns) {
  pack_columns(columns);
  return columns;
}

std::vector<char> record_without_values(const std::vector<Column>& columns) {
  std::vector<char> record(record_size(columns));
  for (const Column& column : columns) store_missing(column, record.data() + column.offset);
  return record;
}

}  // namespace

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

TableWriter::TableWriter(hid_t file, const StoredTable& table)
    : type_(record_type(table.columns, false)),
      dataset_(create_dataset(file, table)),
      record_size_(record_size(table.columns)) {
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
  const auto [in_file, in_memory] = select_records(dataset_.get(), written_, count);
  hdf5_checked(H5Dwrite(dataset_.get(), type_.get(), in_memory.get(), in_file.get(), H5P_DEFAULT,
                        buffer_.data()),
               "write records");
  written_ = size;
  buffer_.clear();
}

void TableWriter::finish() {
  flush();
  write_attribute(dataset_.get(), "NROWS", static_cast<long long>(written_));
}

void write_table(hid_t file, const StoredTable& table) {
  TableWriter writer(file, table);
  for (std::size_t i = 0; i < table.size(); ++i) writer.append(table.record(i));
  writer.finish();
}

TableReader::TableReader(hid_t file, const StoredTable& table, std::uint64_t file_bytes)
    : dataset_(open_own_dataset(file, table.name)),
      wanted_(stored_columns(dataset_.get(), table)),
      found_(packed(wanted_)),
      missing_(record_without_values(table.columns)),
      type_(record_type(found_, false)),
      as_it_is_(found_.size() == table.columns.size()),
      size_(record_count(dataset_.get(), table.name, file_bytes)) {}

const char* TableReader::read(std::size_t i) {
  expect(i < size_, "a table has that record");
  const std::size_t size = record_size(found_);
  if (i < first_ || i >= first_ + count_) {
    count_ = 0;
    first_ = i / kChunkRecords * kChunkRecords;
    const std::size_t count = std::min<std::size_t>(kChunkRecords, size_ - first_);
    buffer_.resize(count * size);
    const auto [in_file, in_memory] = select_records(dataset_.get(), first_, count);
    hdf5_checked(H5Dread(dataset_.get(), type_.get(), in_memory.get(), in_file.get(), H5P_DEFAULT,
                         buffer_.data()),
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

StoredTable read_table(hid_t file, const StoredTable& table, std::uint64_t file_bytes) {
  TableReader reader(file, table, file_bytes);
  StoredTable stored = table;
  for (std::size_t i = 0; i < reader.size(); ++i) {
    const char* record = reader.read(i);
    stored.records.insert(stored.records.end(), record, record + record_size(table.columns));
  }
  return stored;
}

std::size_t stored_text_size(hid_t file, const std::string& table, const std::string& field) {
  const Hdf5Handle dataset = open_own_dataset(file, table);
  const std::optional<Hdf5Handle> type = member_type(type_of(dataset.get(), table).get(), field);
  if (!type) throw Hdf5Error(fmt::format("/{} has no field '{}'", table, field));
  const std::size_t size = H5Tget_size(type->get());
  if (size == 0 || size > kLargestField) {
    throw Hdf5Error(fmt::format("/{}: field '{}' has {} bytes", table, field, size));
  }
  return size;
}

}  // namespace ar3d
