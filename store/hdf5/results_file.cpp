// Results files as they are written: HDF5 with a checksum behind it.
#include "ar3d/store/hdf5/results_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <unordered_set>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/store/hdf5/file_checksum.h"
#include "ar3d/store/hdf5/hdf5_table.h"
#include "ar3d/store/hdf5/results_layout.h"

namespace ar3d {

TableSpec environments_table(std::size_t name_size, std::size_t value_size) {
  TableSpec table{"environments", "machine, compiler, libraries and settings of every session", {}};
  table.fields = {
      {"session", "1", "which process of the study", FieldType::int64, sizeof(std::int64_t)},
      {"name", "", "what is described", FieldType::text, std::max<std::size_t>(1, name_size)},
      {"value", "", "its value", FieldType::text, std::max<std::size_t>(1, value_size)}};
  pack_fields(table.fields);
  return table;
}

namespace {

void write_root_attributes(hid_t file, const StudyIdentity& results) {
  write_attribute(file, "format", kResultsFormat);
  write_attribute(file, "format_version", kResultsFormatVersion);
  write_attribute(file, "study_id", results.study_id);
  write_attribute(file, "spec_hash", results.spec_hash);
  write_attribute(file, "source_hash", results.source_hash);
  write_attribute(file, "dirty", results.dirty ? 1 : 0);
  write_attribute(file, "dirty_hash", results.dirty_hash);
  write_attribute(file, "created", results.created);
  write_attribute(file, "shard", fmt::format("{}/{}", results.shard.index, results.shard.count));
  write_attribute(file, "planned_rows", static_cast<long long>(results.planned_rows));
}

void write_spec(hid_t file, const std::string& spec) {
  const std::size_t size = std::max<std::size_t>(1, spec.size());
  const Hdf5Handle type = text_type(size, H5T_CSET_UTF8);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar");
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "create properties");
  hdf5_checked(H5Pset_obj_track_times(properties.get(), false), "leave time stamps out");
  const Hdf5Handle dataset(
      H5Dcreate2(file, "spec", type.get(), space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
      H5Dclose, "create /spec");
  std::string padded = spec;
  padded.resize(size, '\0');
  hdf5_checked(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()),
               "write /spec");
}

// Takes records and keeps one for every value of the extract's key.
class ExtractWriter {
 public:
  ExtractWriter(hid_t file, const RowFormat& format)
      : format_(format), table_(file, format.extract) {}

  void note(const char* row) {
    if (!seen_.insert(key_of(row)).second) return;
    record_.clear();
    for (const std::size_t field_number : format_.extract_fields) {
      const Field& field = format_.rows.fields[field_number];
      record_.append(row + field.offset, field.size);
    }
    table_.append(record_.data());
  }
  void finish() { table_.finish(); }

 private:
  // The key's fields, hashed.
  RowKey key_of(const char* row) {
    text_.clear();
    for (const std::size_t field_number : format_.extract_key) {
      const Field& field = format_.rows.fields[field_number];
      text_.append(row + field.offset, field.size);
    }
    const XXH128_hash_t hash = XXH3_128bits(text_.data(), text_.size());
    return {hash.high64, hash.low64};
  }

  const RowFormat& format_;
  std::string record_;
  std::string text_;
  TableWriter table_;
  std::unordered_set<RowKey> seen_;
};

void write_rows(hid_t file, const RowFormat& format, const RecordSource& rows) {
  ExtractWriter extract(file, format);
  TableWriter table(file, format.rows);
  std::vector<char> record(format.record_size());
  for (std::size_t i = 0; i < rows.count; ++i) {
    rows.read(i, record.data());
    extract.note(record.data());
    table.append(record.data());
  }
  extract.finish();
  table.finish();
}

void write_side_tables(hid_t file, const StudyIdentity& identity) {
  for (const StoredTable& table : identity.tables) {
    write_table(file, table.spec, table.size(), [&](std::size_t i, char* record) {
      std::memcpy(record, table.record(i), record_size(table.spec.fields));
    });
  }
}

void write_environment(hid_t file, const std::vector<EnvironmentEntry>& environment) {
  std::size_t name_size = 0;
  std::size_t value_size = 0;
  for (const EnvironmentEntry& entry : environment) {
    name_size = std::max(name_size, entry.name.size());
    value_size = std::max(value_size, entry.value.size());
  }
  const TableSpec table = environments_table(name_size, value_size);
  write_table(file, table, environment.size(), [&](std::size_t i, char* to) {
    const std::string name = fitted_text(environment[i].name, table.fields[1].size);
    const std::string value = fitted_text(environment[i].value, table.fields[2].size);
    std::memcpy(to, &environment[i].session, sizeof(environment[i].session));
    name.copy(to + table.fields[1].offset, name.size());
    value.copy(to + table.fields[2].offset, value.size());
  });
}

[[noreturn]] void refuse(const std::string& path, const char* why) {
  throw InputError(fmt::format("cannot write {}: {}", path, why));
}

}  // namespace

void write_results(const StudyIdentity& identity, const std::vector<EnvironmentEntry>& environment,
                   const RowFormat& format, const RecordSource& rows, const std::string& path) {
  NewFile file(path);
  const Hdf5Silence silence;
  try {
    Hdf5Output output(file.descriptor());
    write_root_attributes(output.get(), identity);
    write_spec(output.get(), identity.spec);
    write_environment(output.get(), environment);
    write_side_tables(output.get(), identity);
    write_rows(output.get(), format, rows);
    if (const int error = output.close()) refuse(path, std::strerror(error));
  } catch (const Hdf5Error& error) {
    refuse(path, error.what());
  }
  if (const int error = append_checksum(file.descriptor())) refuse(path, std::strerror(error));
  file.become_target();
}

}  // namespace ar3d
