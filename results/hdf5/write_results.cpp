#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <cstring>
#include <unordered_set>

#include "ar3d/model/error.h"
#include "ar3d/results/atomic_file.h"
#include "ar3d/results/hdf5/hdf5_file.h"
#include "ar3d/results/hdf5/results_format.h"
#include "ar3d/results/row_key.h"

namespace ar3d {
namespace {

void write_root_attributes(hid_t file, const StudyIdentity& results) {
  write_attribute(file, "format", kResultsFormat);
  write_attribute(file, "format_version", kResultsFormatVersion);
  write_attribute(file, "study_id", results.study_id);
  write_attribute(file, "spec_sha256", results.spec_sha256);
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

// What tells instances apart, hashed.
RowKey identity_of(const char* run) {
  static const std::array<Column, 4> columns = {run_column("family"), run_column("parameters"),
                                                run_column("wanted_n"),
                                                run_column("instance_index")};
  std::string text;
  for (const Column& column : columns) text.append(run + column.offset, column.size);
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return {hash.high64, hash.low64};
}

// Takes records of /runs and keeps one record of every instance among them.
class InstanceWriter {
 public:
  explicit InstanceWriter(hid_t file)
      : columns_(columns_of_kind(run_columns(), ColumnKind::instance)),
        record_(record_size(columns_)),
        table_(file, table_of("instances", "one record a graph", columns_)) {
    for (const Column& column : columns_) from_.push_back(run_column(column.name).offset);
  }

  void note(const char* run) {
    if (!seen_.insert(identity_of(run)).second) return;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      std::memcpy(record_.data() + columns_[i].offset, run + from_[i], columns_[i].size);
    }
    table_.append(record_.data());
  }
  void finish() { table_.finish(); }

 private:
  std::vector<Column> columns_;
  std::vector<std::size_t> from_;  // where the columns stand in a record of /runs
  std::vector<char> record_;
  TableWriter table_;
  std::unordered_set<RowKey> seen_;
};

void write_rows(hid_t file, const RecordSource& rows) {
  InstanceWriter instances(file);
  TableWriter runs(file, runs_table());
  std::vector<char> record(run_record_size());
  for (std::size_t i = 0; i < rows.count; ++i) {
    rows.read(i, record.data());
    instances.note(record.data());
    runs.append(record.data());
  }
  instances.finish();
  runs.finish();
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

void write_everything(Hdf5Output& file, const StudyIdentity& identity,
                      const std::vector<EnvironmentEntry>& environment, const RecordSource& rows) {
  write_root_attributes(file.get(), identity);
  write_spec(file.get(), identity.spec);
  write_environment(file.get(), environment);
  write_rows(file.get(), rows);
}

[[noreturn]] void refuse(const std::string& path, const char* why) {
  throw InputError(fmt::format("cannot write {}: {}", path, why));
}

}  // namespace

void write_results(const StudyIdentity& identity, const std::vector<EnvironmentEntry>& environment,
                   const RecordSource& rows, const std::string& path) {
  const Hdf5Silence silence;
  NewFile file = NewFile::to_replace(path);
  try {
    Hdf5Output output(file.descriptor());
    write_everything(output, identity, environment, rows);
    if (const int error = output.close()) refuse(path, std::strerror(error));
  } catch (const Hdf5Error& error) {
    refuse(path, error.what());
  }
  file.become_target();
}

void write_results(const Results& results, const std::string& path) {
  const auto read = [&](std::size_t i, char* record) { store_record(results.runs[i], record); };
  write_results(results, results.environment, {results.runs.size(), read}, path);
}

}  // namespace ar3d
