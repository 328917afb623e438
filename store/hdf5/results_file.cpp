// THE RESULTS FILE, VERSION 3
//
// A results file is an HDF5 file and, behind its end, 40 bytes that HDF5 does not look at:
//
//   attributes of /   format = ar3d-results, format_version = 3, the study's identity, rows_hash
//   /spec             the specification, byte by byte; its hash is an attribute
//   /environments     session, name, value
//   /algorithms, …    side tables, those that the study has
//   /instances        one record per graph: the columns of /runs of kind `instance`
//   /runs             one record per row, in the order of the plan
//   "ar3d-checksum 1\n", the number of bytes before (8 bytes, little endian), and XXH3-128 of
//                     everything up to there (canonical form: big endian)
//
// Every table is a one-dimensional dataset of a compound type, whose fields are the columns of its
// description (columns/table.h), chunked and deflated. What each column is called and means is in
// results/SCHEMA.md, which a test compares with the descriptions.
//
// WRITING. A new file beside the old one, fsync, rename. HDF5 never sees a write fail
// (hdf5_output.cpp): it would not give the file up.
//
// READING. HDF5 sees no damaged file: the checksum is verified before. Since a checksum can be
// forged and HDF5 crashes on some files, it sees none in this process either: a child opens the
// file and answers with records, 512 at once. HDF5 cuts the checksum off where it opens a file for
// writing; then all that is read has to have the hash in rows_hash. Links, foreign filters, huge
// chunks and more records than the bytes can hold are refused there (hdf5_table.cpp).
#include "ar3d/store/hdf5/results_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <xxhash.h>

#include <boost/scope_exit.hpp>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/hdf5/hdf5_table.h"
#include "ar3d/store/journal/journal_format.h"

namespace ar3d {
namespace {

using Json = nlohmann::json;

// What a results file says of itself in its root attributes.
constexpr const char* kResultsFormat = "ar3d-results";
constexpr long long kResultsFormatVersion = 3;

constexpr std::size_t kLargestSpec = std::size_t{1} << 26;
constexpr std::size_t kBlockRows = 512;    // that a question brings
constexpr std::uint64_t kDescription = 0;  // the question for it; i + 1 asks for block i

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

void put(HashStream& hash, const char* bytes, std::size_t size) {
  hash.put(std::uint64_t{XXH3_64bits(bytes, size)});
}

// What a file says of its study, on two lines.
std::string description_of(const StudyIdentity& identity,
                           const std::vector<EnvironmentEntry>& environment) {
  Json entries = Json::array();
  for (const EnvironmentEntry& entry : environment) {
    entries.push_back({entry.name, entry.value, entry.session});
  }
  return fmt::format("{}\n{}", identity_text(identity),
                     entries.dump(-1, ' ', false, Json::error_handler_t::replace));
}

// The table of rows and, of every graph once, their columns that describe it.
void write_rows(hid_t file, std::size_t count,
                const std::function<void(std::size_t i, char* record)>& read, HashStream& hash) {
  std::vector<Column> columns;
  std::ranges::copy_if(run_columns(), std::back_inserter(columns),
                       [](const Column& column) { return column.kind == ColumnKind::instance; });
  StoredTable instances_spec{"instances", "one record per graph", columns};
  pack_columns(instances_spec.columns);
  TableWriter instances(file, instances_spec);
  TableWriter runs(file, runs_spec());
  std::vector<char> row(run_record_size());
  std::string instance, key;
  std::unordered_set<RowKey> seen;
  for (std::size_t i = 0; i < count; ++i) {
    read(i, row.data());
    put(hash, row.data(), row.size());
    instance.clear();
    key.clear();
    for (const Column& column : columns) {
      instance.append(row.data() + column.offset, column.size);
      const bool is_of_key = column.name == "family" || column.name == "parameters" ||
                             column.name == "requested_n" || column.name == "instance_index";
      if (is_of_key) key.append(row.data() + column.offset, column.size);
    }
    const XXH128_hash_t of_key = XXH3_128bits(key.data(), key.size());
    if (seen.insert({of_key.high64, of_key.low64}).second) instances.append(instance.data());
    runs.append(row.data());
  }
  instances.finish();
  runs.finish();
}

// A regular file that begins as HDF5 files do, open to read.
Descriptor open_hdf5_file(const std::string& path) {
  Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) refuse_reading(path, errno);
  struct stat status {};
  if (fstat(file.get(), &status) != 0) refuse_reading(path, errno);
  if (S_ISDIR(status.st_mode)) refuse_reading(path, EISDIR);
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
  return environment_of(
      read_table(file,
                 environments_spec(stored_text_size(file, "environments", "name"),
                                   stored_text_size(file, "environments", "value")),
                 bytes));
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
  const std::string shard = read_text_attribute(file, "shard");
  if (!parse_shard(shard)) throw Hdf5Error(fmt::format("'{}' is no shard", shard));
  identity.shard = *parse_shard(shard);
  identity.planned_rows = read_integer_attribute(file, "planned_rows");
  if (identity.planned_rows < -1) throw Hdf5Error("planned_rows is negative");
  return identity;
}

// Runs `step` without messages of HDF5's own: what it has against the file becomes one line with
// that beginning.
template <class Step>
auto explained(const std::string& beginning, const Step& step) {
  H5E_auto2_t printer = nullptr;
  void* data = nullptr;
  H5Eget_auto2(H5E_DEFAULT, &printer, &data);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  BOOST_SCOPE_EXIT_ALL(&) { H5Eset_auto2(H5E_DEFAULT, printer, data); };
  try {
    return step();
  } catch (const Hdf5Error& error) {
    throw InputError(fmt::format("{}: {}", beginning, error.what()));
  }
}

// Opens the file for the process that only reads it. @return three lines: number of rows and their
// hash, identity, environment.
std::string opened(const std::string& path, int descriptor, std::optional<TableReader>& rows) {
  H5PLset_loading_state(0);  // no filter that a file names is loaded
  std::string name = fmt::format("/proc/self/fd/{}", descriptor);
  if (access(name.c_str(), F_OK) != 0) name = path;  // there is no /proc
  const Hdf5Handle file(H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open it");
  require_format(file.get());
  const std::uint64_t bytes = std::filesystem::file_size(name);
  StudyIdentity identity = read_identity(file.get());
  for (const StoredTable& spec : side_table_specs()) {
    if (hdf5_checked(H5Lexists(file.get(), spec.name.c_str(), H5P_DEFAULT), "look for a table") >
        0) {
      identity.tables.push_back(read_table(file.get(), spec, bytes));
    }
  }
  const std::vector<EnvironmentEntry> environment = read_environment(file.get(), bytes);
  rows.emplace(file.get(), runs_spec(), bytes);
  const bool has_hash = H5Aexists(file.get(), "rows_hash") > 0;
  const Json head = {rows->size(), has_hash ? read_text_attribute(file.get(), "rows_hash") : ""};
  return fmt::format("{}\n{}", head.dump(), description_of(identity, environment));
}

std::string block_of(TableReader& rows, std::uint64_t block) {
  std::string answer;
  const std::size_t end = std::min(rows.size(), kBlockRows * (block + 1));
  for (std::size_t i = kBlockRows * block; i < end; ++i) {
    answer.append(rows.read(i), run_record_size());
  }
  return answer;
}

constexpr const char* kCutOff =
    "it has no checksum at its end: it was cut short, or opened for writing by another program "
    "(pandas.HDFStore, h5py's modes r+ and a)";

// A process that reads a file. @param is_checked  becomes true if its checksum is right.
ReaderProcess process_for(const std::string& path, bool& is_checked) {
  const Descriptor descriptor = open_hdf5_file(path);
  is_checked = has_checksum(descriptor.get(), path);
  if (flock(descriptor.get(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw InputError(fmt::format(
        "{} is open for writing in another program: close it there, then it is read", path));
  }
  flock(descriptor.get(), LOCK_UN);
  std::optional<TableReader> rows;  // in the process; keeps the HDF5 file open
  const std::string beginning = fmt::format("{} is not a readable results file{}{}", path,
                                            is_checked ? "" : ": ", is_checked ? "" : kCutOff);
  const auto answer = [&](std::uint64_t question) {
    return explained(beginning, [&] {
      return question == kDescription ? opened(path, descriptor.get(), rows)
                                      : block_of(rows.value(), question - 1);
    });
  };
  return {path, descriptor, answer};
}

}  // namespace

void write_results(const StudyIdentity& identity, const std::vector<EnvironmentEntry>& environment,
                   std::size_t rows, const std::function<void(std::size_t i, char* record)>& read,
                   const std::string& path) {
  NewFile file(path);
  int error = explained("cannot write " + path, [&] {
    return write_hdf5_file(file.descriptor(), [&](hid_t output) {
      write_root_attributes(output, identity);
      write_spec(output, identity.spec);
      write_table(output, environments_table(environment));
      for (const StoredTable& table : identity.tables) write_table(output, table);
      HashStream hash;
      const std::string description =
          description_of(identity, environment_of(environments_table(environment)));
      put(hash, description.data(), description.size());
      write_rows(output, rows, read, hash);
      write_attribute(output, "rows_hash", hash.digest());
    });
  });
  if (error == 0) error = append_checksum(file.descriptor());
  if (error != 0) refuse_writing(path, error);
  file.become_target();
}

RunReader::RunReader(const std::string& path)
    : path_(path), process_(process_for(path, is_checked_)) {
  const std::string answer = process_.ask(kDescription);
  std::string hash;
  const std::size_t first = answer.find('\n'), second = answer.find('\n', first + 1);
  try {
    const Json head = Json::parse(answer.substr(0, first));
    head.at(0).get_to(size_);
    head.at(1).get_to(hash);
    identity_ = parse_identity(answer.substr(first + 1, second - first - 1), path);
    for (const Json& entry : Json::parse(answer.substr(second + 1))) {
      environment_.push_back({entry.at(0), entry.at(1), entry.at(2)});
    }
  } catch (const Json::exception&) {
    throw InputError(fmt::format("{} is damaged: reading it gives no rows", path));
  }
  if (size_ / kMostRecordsPerByte > std::filesystem::file_size(path)) {
    throw InputError(fmt::format("{} is damaged: it cannot hold {} rows", path, size_));
  }
  if (is_checked_) return;
  if (!hash.empty() && hash == rows_hash(std::string_view(answer).substr(first + 1))) {
    note_on_results(
        fmt::format("{} was opened for writing by another program, which cut its "
                    "checksum off; its rows are those that it was written with, by their hash",
                    path));
    return;
  }
  const std::string cause =
      fmt::format("{}, and {}", kCutOff,
                  hash.empty() ? "it has no rows_hash, as those of earlier programs"
                               : "its rows are not those of its rows_hash");
  if (!accept_changed_results) {
    throw InputError(
        fmt::format("{} is not a readable results file: {}; --accept-changed reads it with its "
                    "rows as they are",
                    path, cause));
  }
  note_on_results(fmt::format(
      "{}: {}; its rows are read as they are; nothing says that the study made them", path, cause));
}

std::string RunReader::rows_hash(std::string_view description) {
  HashStream hash;
  put(hash, description.data(), description.size());
  for (std::size_t i = 0; i < size_; ++i) put(hash, record(i), run_record_size());
  return hash.digest();
}

std::vector<std::vector<EnvironmentEntry>> RunReader::sessions() const {
  std::vector<std::vector<EnvironmentEntry>> sessions;
  for (EnvironmentEntry entry : environment_) {
    const auto number = static_cast<std::size_t>(entry.session);
    if (number > sessions.size()) {
      throw InputError(fmt::format("{}: /environments has no session {}", path_, sessions.size()));
    }
    if (number == sessions.size()) sessions.emplace_back();
    entry.session = 0;
    sessions[number].push_back(std::move(entry));
  }
  return sessions;
}

const char* RunReader::record(std::size_t i) {
  expect(i < size_, "a table has that record");
  if (i / kBlockRows != block_) {
    block_ = SIZE_MAX;
    rows_ = process_.ask(i / kBlockRows + 1);
    block_ = i / kBlockRows;
  }
  if (rows_.size() < (i % kBlockRows + 1) * run_record_size()) {
    throw InputError(fmt::format("{} is damaged: reading row {} gives none", path_, i));
  }
  return rows_.data() + i % kBlockRows * run_record_size();
}

void RunReader::read(std::size_t i, char* record) {
  std::memcpy(record, this->record(i), run_record_size());
}

RowKey RunReader::key(std::size_t i) {
  static const Column& column = run_column("row_key");
  const char* bytes = record(i) + column.offset;
  try {
    return parse_row_key({bytes, column.size});
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: row {}: {}", path_, i, error.what()));
  }
}

}  // namespace ar3d
