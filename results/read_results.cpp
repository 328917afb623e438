#include <fmt/format.h>

#include "ar3d/model/error.h"
#include "ar3d/results/hdf5_file.h"
#include "ar3d/results/results_format.h"

namespace ar3d {
namespace {

void require_format(hid_t file) {
  const std::string format = read_text_attribute(file, "format");
  if (format != kResultsFormat) {
    throw Hdf5Error(fmt::format("its format is '{}', not '{}'", format, kResultsFormat));
  }
  const long long version = read_integer_attribute(file, "format_version");
  if (version != kResultsFormatVersion) {
    throw Hdf5Error(fmt::format("it has format version {}, this program reads version {}", version,
                                kResultsFormatVersion));
  }
}

std::string read_spec(hid_t file) {
  const Hdf5Handle dataset(H5Dopen2(file, "spec", H5P_DEFAULT), H5Dclose, "open /spec");
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose, "read the type of /spec");
  const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose, "read the shape of /spec");
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0 ||
      H5Sget_simple_extent_npoints(space.get()) != 1) {
    throw Hdf5Error("/spec is not one fixed-size string");
  }
  std::string spec(H5Tget_size(type.get()), '\0');
  hdf5_checked(H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, spec.data()),
               "read /spec");
  spec.resize(std::min(spec.size(), spec.find('\0')));
  return spec;
}

std::vector<EnvironmentEntry> read_environment(hid_t file) {
  const TableSpec table = environments_table(stored_text_size(file, "environments", "name"),
                                             stored_text_size(file, "environments", "value"));
  const auto text = [](const char* at, std::size_t size) {
    return std::string(at, strnlen(at, size));
  };
  std::vector<EnvironmentEntry> entries;
  read_table(file, table, [&](const char* record) {
    const Field& value = table.fields[1];
    entries.push_back(
        {text(record, table.fields[0].size), text(record + value.offset, value.size)});
  });
  return entries;
}

std::vector<Run> read_runs(hid_t file) {
  std::vector<Run> runs;
  read_table(file, runs_table(), [&](const char* record) {
    Run& run = runs.emplace_back();
    for (const Column& column : run_columns()) column.load(record + column.offset, run);
  });
  return runs;
}

Results read_file(const std::string& path) {
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open it");
  require_format(file.get());
  Results results;
  results.study_id = read_text_attribute(file.get(), "study_id");
  results.spec_sha256 = read_text_attribute(file.get(), "spec_sha256");
  results.source_hash = read_text_attribute(file.get(), "source_hash");
  results.dirty = read_integer_attribute(file.get(), "dirty") != 0;
  results.created = read_text_attribute(file.get(), "created");
  results.spec = read_spec(file.get());
  results.environment = read_environment(file.get());
  results.runs = read_runs(file.get());
  return results;
}

}  // namespace

Results read_results(const std::string& path) {
  const Hdf5Silence silence;
  require_hdf5_file(path);
  try {
    return read_file(path);
  } catch (const Hdf5Error& error) {
    throw InputError(fmt::format("{} is not a readable results file: {}", path, error.what()));
  }
}

}  // namespace ar3d
