#include <fmt/format.h>

#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/store/hdf5/file_checksum.h"
#include "ar3d/store/hdf5/hdf5_file.h"
#include "ar3d/store/hdf5/hdf5_records.h"
#include "ar3d/store/hdf5/results_format.h"
#include "ar3d/store/hdf5/results_reader.h"

namespace ar3d {
namespace {

constexpr std::size_t kLargestSpec = std::size_t{1} << 26;

// @return the version.
long long require_format(hid_t file) {
  const std::string format = read_text_attribute(file, "format");
  if (format != kResultsFormat) {
    throw Hdf5Error(fmt::format("its format is '{}', not '{}'", format, kResultsFormat));
  }
  const long long version = read_integer_attribute(file, "format_version");
  if (version != kResultsFormatVersion && version != kFormerVersion) {
    throw Hdf5Error(fmt::format("it has format version {}, this program reads versions {} and {}",
                                version, kFormerVersion, kResultsFormatVersion));
  }
  return version;
}

std::string read_spec(hid_t file) {
  const Hdf5Handle dataset = hdf5::open_own_dataset(file, "spec");
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
  const auto text = [](const char* at, std::size_t size) {
    return std::string(at, strnlen(at, size));
  };
  std::vector<EnvironmentEntry> entries;
  read_table(file, table, bytes, [&](const char* record) {
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
      static_cast<std::size_t>(used) != text.size() || !is_shard(shard)) {
    throw Hdf5Error(fmt::format("'{}' is no shard", text));
  }
  return shard;
}

std::string read_spec_hash(hid_t file, long long version, const std::string& spec) {
  if (version == kFormerVersion) return content_hash(spec);  // it has one of another kind
  std::string hash = read_text_attribute(file, "spec_hash");
  if (hash != content_hash(spec)) throw Hdf5Error("/spec is not what spec_hash says");
  return hash;
}

StudyIdentity read_identity(hid_t file, long long version) {
  StudyIdentity identity;
  identity.study_id = read_text_attribute(file, "study_id");
  identity.spec = read_spec(file);
  identity.spec_hash = read_spec_hash(file, version, identity.spec);
  identity.source_hash = read_text_attribute(file, "source_hash");
  identity.dirty = read_integer_attribute(file, "dirty") != 0;
  if (H5Aexists(file, "dirty_hash") > 0) {  // files of older programs lack it
    identity.dirty_hash = read_text_attribute(file, "dirty_hash");
  }
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

// Whether the file is of the present version and whole, so that HDF5 may see it. @throws InputError
// if it is damaged.
bool has_checksum(int file, const std::string& path) {
  const ChecksumVerdict verdict = verify_checksum(file, path);
  if (verdict == ChecksumVerdict::wrong) {
    throw InputError(
        fmt::format("{} is damaged: its bytes are not those that its checksum was made of", path));
  }
  return verdict == ChecksumVerdict::right;
}

}  // namespace

OpenResults open_results(int descriptor, long long version, const RowFormat& format) {
  H5PLset_loading_state(0);  // no filter that a file names is loaded
  const Hdf5Silence silence;
  const std::string path = fmt::format("/proc/self/fd/{}", descriptor);
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open it");
  const long long found = require_format(file.get());
  if (found != version && version == kFormerVersion) {
    throw Hdf5Error(
        "it has no checksum at its end: it was cut short or changed by another program");
  }
  if (found != version) throw Hdf5Error("files of version 2 have no checksum");
  const std::uint64_t bytes = std::filesystem::file_size(path);
  StudyIdentity identity = read_identity(file.get(), version);
  identity.tables = read_tables(file.get(), format, bytes);
  std::vector<EnvironmentEntry> environment = read_environment(file.get(), bytes);
  return {std::move(file), bytes, std::move(identity), std::move(environment)};
}

namespace {

// Once a process for every file.
void say_unchecked(const std::string& path) {
  static std::mutex mutex;
  static std::set<std::string> said;
  const std::lock_guard lock(mutex);
  if (!said.insert(path).second) return;
  fmt::print(stderr,
             "ar3d: {}: a file of version 2 has no checksum: a value that was changed in it is not "
             "noticed\n",
             printable(path));
}

}  // namespace

struct ResultsReader::File {
  std::string path;
  TableReader rows;  // keeps the HDF5 file open
};

ResultsReader::ResultsReader(const std::string& path, const RowFormat& format) {
  explained(path, [&] {
    const Descriptor file = open_hdf5_file(path);
    std::optional<TemporaryFile> converted;
    if (!has_checksum(file.get(), path)) {
      convert_former(file.get(), converted.emplace().descriptor(), format, path);
      say_unchecked(path);
    }
    const int whole = converted ? converted->descriptor() : file.get();
    OpenResults opened = open_results(whole, kResultsFormatVersion, format);
    identity_ = std::move(opened.identity);
    environment_ = std::move(opened.environment);
    file_.reset(new File{path, TableReader(opened.file.get(), format.rows, opened.bytes)});
  });
}

ResultsReader::~ResultsReader() = default;
ResultsReader::ResultsReader(ResultsReader&&) noexcept = default;

std::size_t ResultsReader::size() const { return file_->rows.size(); }

const char* ResultsReader::read(std::size_t i) {
  return explained(file_->path, [&] { return file_->rows.read(i); });
}

}  // namespace ar3d
