#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <set>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/store/hdf5/apart.h"
#include "ar3d/store/hdf5/results_format.h"

namespace ar3d {
namespace {

constexpr unsigned kLeastSeconds = 60;
constexpr off_t kBytesPerSecond = 1 << 16;  // of the file; ten times slower than it is

// What every session says from now on, in whatever file its rows are.
void mark_unchecked(std::vector<EnvironmentEntry>& environment) {
  std::set<std::int64_t> sessions;
  for (const EnvironmentEntry& entry : environment) sessions.insert(entry.session);
  if (sessions.empty()) sessions.insert(1);
  for (const std::int64_t session : sessions) {
    const auto end =
        std::find_if(environment.rbegin(), environment.rend(),
                     [&](const EnvironmentEntry& entry) { return entry.session == session; });
    environment.insert(end.base(),
                       {"checksum", "none: the rows are of a file of version 2", session});
  }
}

void convert(int from, int to, const RowFormat& format, const std::string& path) {
  OpenResults former = open_results(from, kFormerVersion, format);
  TableSpec rows = format.rows;
  rows.fields.insert(rows.fields.end(), format.former_fields.begin(), format.former_fields.end());
  pack_fields(rows.fields);
  TableReader reader(former.file.get(), rows, former.bytes, FieldNames::former);
  for (std::size_t i = 0; i < reader.size(); ++i) {
    format.keep_of_former(reader.read(i), former.identity);
  }
  const auto read = [&](std::size_t i, char* record) {
    std::memcpy(record, reader.read(i), format.record_size());
  };
  mark_unchecked(former.environment);
  write_results_into(to, former.identity, former.environment, format, {reader.size(), read}, path);
}

}  // namespace

TemporaryFile::TemporaryFile()
    : path_((std::filesystem::temp_directory_path() / "ar3d-XXXXXX").string()),
      descriptor_(mkostemp(path_.data(), O_CLOEXEC)) {
  if (descriptor_.get() < 0) {
    throw InputError(
        fmt::format("cannot make a temporary file {}: {}", path_, std::strerror(errno)));
  }
}

TemporaryFile::~TemporaryFile() { unlink(path_.c_str()); }

void convert_former(int former, int converted, const RowFormat& format, const std::string& path) {
  struct stat status {};
  fstat(former, &status);
  const std::string problem =
      do_apart([&] { convert(former, converted, format, path); },
               kLeastSeconds + static_cast<unsigned>(status.st_size / kBytesPerSecond));
  if (!problem.empty()) throw Hdf5Error(problem);
}

}  // namespace ar3d
