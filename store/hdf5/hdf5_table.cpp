#include "ar3d/store/hdf5/hdf5_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "ar3d/store/hdf5/hdf5_records.h"

namespace ar3d {
namespace {

constexpr hsize_t kChunkRecords = 512;
constexpr unsigned kCompressionLevel = 1;

Hdf5Handle create_dataset(hid_t file, const TableSpec& table) {
  const hsize_t size = 0;
  const hsize_t unlimited = H5S_UNLIMITED;
  const Hdf5Handle space(H5Screate_simple(1, &size, &unlimited), H5Sclose,
                         "create a table's shape");
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "create properties");
  hdf5_checked(H5Pset_chunk(properties.get(), 1, &kChunkRecords), "set chunks");
  hdf5_checked(H5Pset_deflate(properties.get(), kCompressionLevel), "set compression");
  hdf5_checked(H5Pset_obj_track_times(properties.get(), false), "leave time stamps out");
  const Hdf5Handle type = hdf5::record_type(table.fields, hdf5::Place::file);
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

}  // namespace

TableWriter::TableWriter(hid_t file, const TableSpec& table)
    : type_(hdf5::record_type(table.fields, hdf5::Place::memory)),
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
  const hdf5::Slab slab = hdf5::select_records(dataset_.get(), written_, count);
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

}  // namespace ar3d
