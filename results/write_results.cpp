#include <fmt/format.h>

#include <set>
#include <tuple>

#include "ar3d/model/error.h"
#include "ar3d/results/atomic_file.h"
#include "ar3d/results/hdf5_file.h"
#include "ar3d/results/results_format.h"

namespace ar3d {
namespace {

void write_root_attributes(hid_t file, const Results& results) {
  write_attribute(file, "format", kResultsFormat);
  write_attribute(file, "format_version", kResultsFormatVersion);
  write_attribute(file, "study_id", results.study_id);
  write_attribute(file, "spec_sha256", results.spec_sha256);
  write_attribute(file, "source_hash", results.source_hash);
  write_attribute(file, "dirty", results.dirty ? 1 : 0);
  write_attribute(file, "created", results.created);
}

void write_spec(hid_t file, const std::string& spec) {
  const std::size_t size = std::max<std::size_t>(1, spec.size());
  const Hdf5Handle type = text_type(size, H5T_CSET_UTF8);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar");
  const Hdf5Handle dataset(
      H5Dcreate2(file, "spec", type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, "create /spec");
  std::string padded = spec;
  padded.resize(size, '\0');
  hdf5_checked(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()),
               "write /spec");
}

void store_record(const std::vector<Column>& columns, const Run& run, char* record) {
  for (const Column& column : columns) column.store(run, record + column.offset);
}

void write_instances(hid_t file, const std::vector<Run>& runs) {
  const std::vector<Column> columns = columns_of_kind(run_columns(), ColumnKind::instance);
  std::set<std::tuple<std::string, std::string, std::int64_t, std::int64_t>> seen;
  std::vector<const Run*> first_runs;
  for (const Run& run : runs) {
    if (seen.emplace(run.family, run.parameters, run.wanted_n, run.instance_index).second) {
      first_runs.push_back(&run);
    }
  }
  write_table(file, table_of("instances", "one record a graph", columns), first_runs.size(),
              [&](std::size_t i, char* to) { store_record(columns, *first_runs[i], to); });
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
    const std::string name = fitted_text(environment[i].name, table.fields[0].size);
    const std::string value = fitted_text(environment[i].value, table.fields[1].size);
    name.copy(to, name.size());
    value.copy(to + table.fields[1].offset, value.size());
  });
}

std::vector<char> results_image(const Results& results) {
  const Hdf5Handle file = create_hdf5_in_memory();
  write_root_attributes(file.get(), results);
  write_spec(file.get(), results.spec);
  write_environment(file.get(), results.environment);
  write_instances(file.get(), results.runs);
  write_table(file.get(), runs_table(), results.runs.size(), [&](std::size_t i, char* record) {
    store_record(run_columns(), results.runs[i], record);
  });
  return hdf5_image(file.get());
}

}  // namespace

void write_results(const Results& results, const std::string& path) {
  const Hdf5Silence silence;
  try {
    write_file_atomically(path, results_image(results));
  } catch (const Hdf5Error& error) {
    throw InputError(fmt::format("cannot write {}: {}", path, error.what()));
  }
}

}  // namespace ar3d
