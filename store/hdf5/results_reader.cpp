// Results files, read row by row. HDF5 never sees a file that is damaged, as its checksum tells;
// and since a checksum can be forged and HDF5 crashes on some files, it sees none in this process.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/store/hdf5/file_checksum.h"
#include "ar3d/store/hdf5/hdf5_table.h"
#include "ar3d/store/hdf5/reader_process.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/hdf5/results_layout.h"
#include "ar3d/store/journal/journal_format.h"

namespace ar3d {
namespace {

constexpr std::size_t kLargestSpec = std::size_t{1} << 26;

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

constexpr std::size_t kBlockRows = 512;    // that a question brings
constexpr std::uint64_t kDescription = 0;  // the question for it; i + 1 asks for block i

void put_text(std::string& to, const std::string& text) {
  const std::uint64_t size = text.size();
  to.append(reinterpret_cast<const char*>(&size), sizeof(size)).append(text);
}

std::string number_text(std::uint64_t number) {
  return {reinterpret_cast<const char*>(&number), sizeof(number)};
}

// What was put, taken in the same order.
class Parts {
 public:
  Parts(const std::string& path, std::string_view answer) : path_(path), rest_(answer) {}
  bool any() const { return !rest_.empty(); }
  std::string text() { return std::string(bytes(number_in(bytes(sizeof(std::uint64_t))))); }
  std::uint64_t number() { return number_in(text()); }

 private:
  std::uint64_t number_in(std::string_view text) const {
    std::uint64_t number = 0;
    require(text.size() == sizeof(number));
    std::memcpy(&number, text.data(), sizeof(number));
    return number;
  }
  std::string_view bytes(std::size_t size) {
    require(rest_.size() >= size);
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  void require(bool holds) const {
    if (!holds) throw InputError(fmt::format("{} is damaged: reading it gives no rows", path_));
  }

  const std::string& path_;
  std::string_view rest_;
};

// What is read of a file in the process that only reads it.
class OpenResults {
 public:
  OpenResults(std::string path, int descriptor, const RowFormat& format)
      : path_(std::move(path)), descriptor_(descriptor), format_(format) {}

  std::string answer(std::uint64_t question) {
    return explained(path_, [&] { return question == kDescription ? open() : rows(question - 1); });
  }

 private:
  std::string open() {
    H5PLset_loading_state(0);  // no filter that a file names is loaded
    std::string opened = fmt::format("/proc/self/fd/{}", descriptor_);
    if (access(opened.c_str(), F_OK) != 0) opened = path_;  // there is no /proc
    const Hdf5Handle file(H5Fopen(opened.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                          "open it");
    require_format(file.get());
    const std::uint64_t bytes = std::filesystem::file_size(opened);
    StudyIdentity identity = read_identity(file.get());
    identity.tables = read_tables(file.get(), format_, bytes);
    const std::vector<EnvironmentEntry> environment = read_environment(file.get(), bytes);
    rows_.emplace(file.get(), format_.rows, bytes);
    std::string answer;
    put_text(answer, number_text(rows_->size()));
    put_text(answer, identity_text(identity, format_));
    for (const EnvironmentEntry& entry : environment) {
      put_text(answer, number_text(static_cast<std::uint64_t>(entry.session)));
      put_text(answer, entry.name);
      put_text(answer, entry.value);
    }
    return answer;
  }

  std::string rows(std::uint64_t block) {
    std::string answer;
    const std::size_t end = std::min(rows_->size(), kBlockRows * (block + 1));
    for (std::size_t i = kBlockRows * block; i < end; ++i) {
      answer.append(rows_->read(i), format_.record_size());
    }
    return answer;
  }

  std::string path_;
  int descriptor_;
  const RowFormat& format_;
  std::optional<TableReader> rows_;  // keeps the HDF5 file open
};

// A process that reads a file once its checksum is right.
ReaderProcess process_for(const std::string& path, const RowFormat& format) {
  const Descriptor descriptor = open_hdf5_file(path);
  explained(path, [&] { require_checksum(descriptor.get(), path); });
  const auto file = std::make_shared<OpenResults>(path, descriptor.get(), format);
  return {path, descriptor, [file](std::uint64_t question) { return file->answer(question); }};
}

}  // namespace

struct ResultsReader::File {
  File(const std::string& path, const RowFormat& format)
      : path(path), process(process_for(path, format)), record_size(format.record_size()) {}

  const char* read(std::size_t i) {
    expect(i < size, "a table has that record");
    if (i / kBlockRows != block) {
      block = SIZE_MAX;
      rows = &process.ask(i / kBlockRows + 1);
      block = i / kBlockRows;
    }
    if (rows->size() < (i % kBlockRows + 1) * record_size) {
      throw InputError(fmt::format("{} is damaged: reading row {} gives none", path, i));
    }
    return rows->data() + i % kBlockRows * record_size;
  }

  std::string path;
  ReaderProcess process;
  std::size_t record_size;
  std::size_t size = 0;
  std::size_t block = SIZE_MAX;  // that is in `rows`
  const std::string* rows = nullptr;
};

ResultsReader::ResultsReader(const std::string& path, const RowFormat& format)
    : file_(std::make_unique<File>(path, format)) {
  const std::string answer = file_->process.ask(kDescription);
  Parts parts(path, answer);
  file_->size = parts.number();
  if (file_->size / kMostRecordsPerByte > std::filesystem::file_size(path)) {
    throw InputError(fmt::format("{} is damaged: it cannot hold {} rows", path, file_->size));
  }
  identity_ = parse_identity(parts.text(), format, path);
  while (parts.any()) {
    const auto session = static_cast<std::int64_t>(parts.number());
    const std::string name = parts.text();
    environment_.push_back({name, parts.text(), session});
  }
}

ResultsReader::~ResultsReader() = default;
ResultsReader::ResultsReader(ResultsReader&&) noexcept = default;

std::size_t ResultsReader::size() const { return file_->size; }
const char* ResultsReader::read(std::size_t i) { return file_->read(i); }

}  // namespace ar3d
