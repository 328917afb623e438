#include <fmt/format.h>

#include <cinttypes>
#include <cstdio>
#include <cstring>

#include "ar3d/model/error.h"
#include "ar3d/results/hdf5/hdf5_file.h"
#include "ar3d/results/hdf5/results_format.h"
#include "ar3d/results/hdf5/results_reader.h"

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
    const Field& name = table.fields[1];
    const Field& value = table.fields[2];
    EnvironmentEntry entry{text(record + name.offset, name.size),
                           text(record + value.offset, value.size)};
    std::memcpy(&entry.session, record, sizeof(entry.session));
    entries.push_back(std::move(entry));
  });
  return entries;
}

Shard parse_shard(const std::string& text) {
  Shard shard;
  int used = 0;
  if (std::sscanf(text.c_str(), "%" SCNu32 "/%" SCNu32 "%n", &shard.index, &shard.count, &used) !=
          2 ||
      static_cast<std::size_t>(used) != text.size() || shard.index < 1 ||
      shard.index > shard.count) {
    throw Hdf5Error(fmt::format("'{}' is no shard", text));
  }
  return shard;
}

StudyIdentity read_identity(hid_t file) {
  require_format(file);
  StudyIdentity identity;
  identity.study_id = read_text_attribute(file, "study_id");
  identity.spec_sha256 = read_text_attribute(file, "spec_sha256");
  identity.source_hash = read_text_attribute(file, "source_hash");
  identity.dirty = read_integer_attribute(file, "dirty") != 0;
  if (H5Aexists(file, "dirty_hash") > 0) {  // files of older programs lack it
    identity.dirty_hash = read_text_attribute(file, "dirty_hash");
  }
  identity.created = read_text_attribute(file, "created");
  identity.shard = parse_shard(read_text_attribute(file, "shard"));
  identity.planned_rows = read_integer_attribute(file, "planned_rows");
  identity.spec = read_spec(file);
  return identity;
}

// Runs `step`; what HDF5 has against the file becomes one line that names it.
template <class Step>
auto explained(const std::string& path, const Step& step) {
  const Hdf5Silence silence;
  try {
    return step();
  } catch (const Hdf5Error& error) {
    throw InputError(fmt::format("{} is not a readable results file: {}", path, error.what()));
  }
}

Hdf5Handle open_file(const std::string& path) {
  require_hdf5_file(path);
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open it"};
}

}  // namespace

struct ResultsReader::File {
  explicit File(const std::string& path)
      : path(path), file(open_file(path)), table(file.get(), runs_table()) {}
  std::string path;
  Hdf5Handle file;
  TableReader table;
};

ResultsReader::ResultsReader(const std::string& path) {
  explained(path, [&] {
    file_ = std::make_unique<File>(path);
    identity_ = read_identity(file_->file.get());
    environment_ = read_environment(file_->file.get());
  });
}

ResultsReader::~ResultsReader() = default;
ResultsReader::ResultsReader(ResultsReader&&) noexcept = default;

std::size_t ResultsReader::size() const { return file_->table.size(); }

const char* ResultsReader::read(std::size_t i) {
  return explained(file_->path, [&] { return file_->table.read(i); });
}

Results read_results(const std::string& path) {
  ResultsReader reader(path);
  Results results;
  static_cast<StudyIdentity&>(results) = reader.identity();
  results.environment = reader.environment();
  results.runs.reserve(reader.size());
  for (std::size_t i = 0; i < reader.size(); ++i) {
    results.runs.push_back(load_record(reader.read(i)));
  }
  return results;
}

}  // namespace ar3d
