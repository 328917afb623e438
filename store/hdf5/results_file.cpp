// Results files, read row by row and written whole: HDF5 with a checksum behind it, so that HDF5
// never sees a file that is damaged or that another program made.
#include "ar3d/store/hdf5/results_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <unordered_set>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/store/hdf5/file_checksum.h"
#include "ar3d/store/hdf5/hdf5_table.h"

namespace ar3d {
namespace {

constexpr const char* kResultsFormat = "ar3d-results";
constexpr long long kResultsFormatVersion = 3;
constexpr std::size_t kLargestSpec = std::size_t{1} << 26;

// /environments: session, name and value, as wide as they are.
TableSpec environments_table(std::size_t name_size, std::size_t value_size) {
  TableSpec table{"environments", "machine, compiler, libraries and settings of every session", {}};
  table.fields = {
      {"session", "1", "which process of the study", FieldType::int64, sizeof(std::int64_t)},
      {"name", "", "what is described", FieldType::text, std::max<std::size_t>(1, name_size)},
      {"value", "", "its value", FieldType::text, std::max<std::size_t>(1, value_size)}};
  pack_fields(table.fields);
  return table;
}

// A regular file that begins as HDF5 files do, open to read.
Descriptor open_hdf5_file(const std::string& path) {
  const auto refuse = [&](int reason) {
    throw InputError(fmt::format("cannot read {}: {}", path, std::strerror(reason)));
  };
  Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) refuse(errno);
  struct stat status {};
  if (fstat(file.get(), &status) != 0) refuse(errno);
  if (S_ISDIR(status.st_mode)) refuse(EISDIR);
  constexpr std::string_view kSignature("\211HDF\r\n\032\n", 8);
  char start[kSignature.size()] = {};
  if (!S_ISREG(status.st_mode) || pread(file.get(), start, sizeof(start), 0) != sizeof(start) ||
      std::string_view(start, sizeof(start)) != kSignature) {
    throw InputError(fmt::format("{} is not an HDF5 file", path));
  }
  return file;
}

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
  const Hdf5Handle dataset = open_own_dataset(file, "spec");
  const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose, "read the type of /spec");
  const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose, "read the shape of /spec");
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0 ||
      H5Sget_simple_extent_npoints(space.get()) != 1 || H5Tget_size(type.get()) > kLargestSpec) {
    throw Hdf5Error("/spec is not one string of fixed size");
  }
  std::string spec(H5Tget_size(type.get()), '\0');
  hdf5_checked(H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, spec.data()),
               "read /spec");
  spec.resize(std::min(spec.size(), spec.find('\0')));
  return spec;
}

std::vector<EnvironmentEntry> read_environment(hid_t file, std::uint64_t bytes) {
  const TableSpec table = environments_table(stored_text_size(file, "environments", "name"),
                                             stored_text_size(file, "environments", "value"));
  std::vector<EnvironmentEntry> entries;
  read_table(file, table, bytes, [&](const char* record) {
    EnvironmentEntry entry{text_of(table.fields[1], record), text_of(table.fields[2], record)};
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
      static_cast<std::size_t>(used) != text.size() || !is_shard(shard)) {
    throw Hdf5Error(fmt::format("'{}' is no shard", text));
  }
  return shard;
}

StudyIdentity read_identity(hid_t file) {
  StudyIdentity identity;
  identity.study_id = read_text_attribute(file, "study_id");
  identity.spec = read_spec(file);
  identity.spec_hash = read_text_attribute(file, "spec_hash");
  if (identity.spec_hash != content_hash(identity.spec)) {
    throw Hdf5Error("/spec is not what spec_hash says");
  }
  identity.source_hash = read_text_attribute(file, "source_hash");
  identity.dirty = read_integer_attribute(file, "dirty") != 0;
  identity.dirty_hash = read_text_attribute(file, "dirty_hash");
  identity.created = read_text_attribute(file, "created");
  identity.shard = parse_shard(read_text_attribute(file, "shard"));
  identity.planned_rows = read_integer_attribute(file, "planned_rows");
  if (identity.planned_rows < -1) throw Hdf5Error("planned_rows is negative");
  return identity;
}

std::vector<StoredTable> read_tables(hid_t file, const RowFormat& format, std::uint64_t bytes) {
  std::vector<StoredTable> tables;
  for (const TableSpec& spec : format.tables) {
    if (!has_table(file, spec.name)) continue;
    StoredTable table{spec, {}};
    const std::size_t size = record_size(spec.fields);
    read_table(file, spec, bytes, [&](const char* record) {
      table.records.insert(table.records.end(), record, record + size);
    });
    tables.push_back(std::move(table));
  }
  return tables;
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

// HDF5 may see the file from here on. @throws InputError, Hdf5Error if it is damaged.
void require_checksum(int file, const std::string& path) {
  switch (verify_checksum(file, path)) {
    case ChecksumVerdict::right:
      return;
    case ChecksumVerdict::none:
      throw Hdf5Error(
          "it has no checksum at its end: it was cut short or changed by another program");
    case ChecksumVerdict::wrong:
      throw InputError(fmt::format(
          "{} is damaged: its bytes are not those that its checksum was made of", path));
  }
}

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

struct ResultsReader::File {
  std::string path;
  TableReader rows;  // keeps the HDF5 file open
};

ResultsReader::ResultsReader(const std::string& path, const RowFormat& format) {
  explained(path, [&] {
    const Descriptor descriptor = open_hdf5_file(path);
    require_checksum(descriptor.get(), path);
    H5PLset_loading_state(0);  // no filter that a file names is loaded
    const std::string opened = fmt::format("/proc/self/fd/{}", descriptor.get());
    const Hdf5Handle file(H5Fopen(opened.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                          "open it");
    require_format(file.get());
    const std::uint64_t bytes = std::filesystem::file_size(opened);
    identity_ = read_identity(file.get());
    identity_.tables = read_tables(file.get(), format, bytes);
    environment_ = read_environment(file.get(), bytes);
    file_.reset(new File{path, TableReader(file.get(), format.rows, bytes)});
  });
}

ResultsReader::~ResultsReader() = default;
ResultsReader::ResultsReader(ResultsReader&&) noexcept = default;

std::size_t ResultsReader::size() const { return file_->rows.size(); }

const char* ResultsReader::read(std::size_t i) {
  return explained(file_->path, [&] { return file_->rows.read(i); });
}

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
