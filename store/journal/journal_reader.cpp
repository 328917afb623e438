// A journal's lines, checked one after the other, and its rows by number. What a crash cut short
// at the end is left out; damage before it is reported with its offset.
#include "ar3d/store/journal/journal_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>

#include "ar3d/base/error.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

constexpr std::size_t kReadAtOnce = std::size_t{1} << 20;
constexpr std::size_t kLongestLine = std::size_t{1} << 28;

// A journal's lines, read through a buffer that holds what was asked for last.
class JournalLines {
 public:
  JournalLines(int file, const std::string& path) : file_(file), path_(path) {
    struct stat status {};
    if (fstat(file, &status) != 0) refuse_reading(path, errno);
    size_ = static_cast<std::uint64_t>(status.st_size);
    fill(0, kReadAtOnce);
    if (buffer_.starts_with(kJournalStart)) return;
    throw InputError(fmt::format(
        "{} is not a journal of this version of ar3d{}", path,
        begins_as_journal(buffer_) ? ": finish it with the program that began it" : ""));
  }
  std::uint64_t size() const { return size_; }

  /// The record that begins at `offset`, if it is whole, and its line's length.
  std::optional<JournalRecord> record_at(std::uint64_t offset) {
    return parse_line(line_at(offset), offset);
  }

  /// The first whole record that begins at `from` or behind it. Of a line only the last beginning
  /// of a record can be one.
  std::optional<JournalRecord> next_record(std::uint64_t from) {
    while (from < size_) {
      const std::string_view line = line_at(from);
      const std::size_t start = line.rfind(kRecordStart);
      if (start != line.npos) {
        if (const auto record = parse_line(line.substr(start), from + start)) return record;
      }
      from += line.empty() ? kLongestLine : line.size();
    }
    return std::nullopt;
  }

  std::uint64_t end_of(const JournalRecord& record) {
    return record.offset + line_at(record.offset).size();
  }

 private:
  /// From `offset` to the end of its line; empty if there is none.
  std::string_view line_at(std::uint64_t offset) {
    for (std::size_t count = kReadAtOnce; offset < size_; count *= 4) {
      if (offset >= begin_ && offset < begin_ + buffer_.size()) {
        const std::string_view rest = std::string_view(buffer_).substr(offset - begin_);
        const std::size_t end = rest.find('\n');
        if (end != rest.npos) return rest.substr(0, end + 1);
        if (begin_ + buffer_.size() >= size_ || rest.size() >= kLongestLine) return {};
      }
      fill(offset, count);
    }
    return {};
  }

  void fill(std::uint64_t offset, std::size_t count) {
    buffer_.resize(std::min<std::uint64_t>(count, size_ - offset));
    const std::size_t have = read_whole(file_, buffer_, offset);
    if (have < buffer_.size() && errno != 0) refuse_reading(path_, errno);
    if (have < buffer_.size()) size_ = offset + have;  // it has shrunk
    buffer_.resize(have);
    begin_ = offset;
  }

  int file_;
  const std::string& path_;
  std::uint64_t size_ = 0;
  std::uint64_t begin_ = 0;
  std::string buffer_;
};

Descriptor open_to_read(const std::string& path) {
  Descriptor file = open_input(path);
  if (file.get() < 0) refuse_reading(path, errno);
  return file;
}

void require_beginning(const StudyIdentity& identity, const std::string& path) {
  if (identity.spec_hash.empty()) {
    throw InputError(fmt::format("{} is a journal without a beginning", path));
  }
}

}  // namespace

std::uint64_t scan_journal(int file, const std::string& path,
                           const std::function<bool(const JournalRecord&)>& visit) {
  JournalLines lines(file, path);
  std::uint64_t offset = 0;
  while (const std::optional<JournalRecord> record = lines.record_at(offset)) {
    if (!visit(*record)) return offset;
    offset = lines.end_of(*record);
  }
  if (const auto next = lines.next_record(offset + 1)) {
    throw InputError(fmt::format(
        "{}: damaged at byte {}: the record there fails its checksum, the next whole one begins at "
        "byte {}",
        path, offset, next->offset));
  }
  return offset;
}

JournalRecord last_journal_record(int file, const std::string& path) {
  JournalLines lines(file, path);
  for (std::uint64_t window = kReadAtOnce / 16;; window *= 4) {
    const std::uint64_t from = window < lines.size() ? lines.size() - window : 0;
    std::optional<JournalRecord> last;
    for (auto record = lines.next_record(from); record;
         record = lines.next_record(lines.end_of(*record))) {
      last = record;
      last->payload = {};
    }
    if (last || from == 0) return last.value_or(JournalRecord());
  }
}

JournalStatus journal_status(const std::string& path) {
  const Descriptor file = open_to_read(path);
  JournalStatus status;
  scan_journal(file.get(), path, [&](const JournalRecord& record) {
    status.identity = parse_identity(record.payload, path);
    return false;  // the first record is all that is asked for
  });
  require_beginning(status.identity, path);
  const JournalRecord last = last_journal_record(file.get(), path);
  status.rows = last.rows;
  status.not_ok = last.not_ok;
  struct flock range {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  status.writers = fcntl(file.get(), F_OFD_GETLK, &range) == 0 && range.l_type != F_UNLCK;
  status.journals = 1;
  return status;
}

JournalReader::JournalReader(std::string path)
    : path_(std::move(path)), file_(open_to_read(path_)) {
  scan_journal(file_.get(), path_, [this](const JournalRecord& record) {
    if (record.kind == kRow) {
      constexpr std::string_view kKey = R"({"row_key":")";  // the rest of the row is not looked at
      const bool has_key = record.payload.starts_with(kKey);
      keys_.push_back(parse_row_key(has_key ? record.payload.substr(kKey.size(), 32) : ""));
      rows_.emplace_back(record.payload_offset, record.payload.size());
    } else if (record.kind == kIdentity) {
      identity_ = parse_identity(record.payload, path_);
    } else if (record.kind == kSession) {
      sessions_.push_back(parse_session(record.payload, path_));
    } else if (sessions_.empty()) {
      throw InputError(fmt::format("{}: a session ends that has not begun", path_));
    } else {
      std::ranges::move(parse_session(record.payload, path_), std::back_inserter(sessions_.back()));
    }
    return true;
  });
  require_beginning(identity_, path_);
}

void JournalReader::read(std::size_t i, char* record) const {
  const auto [offset, size] = rows_.at(i);
  std::string json(size, '\0');
  errno = EIO;  // what a file that has shrunk is
  if (pread(file_.get(), json.data(), json.size(), static_cast<off_t>(offset)) !=
      static_cast<ssize_t>(json.size())) {
    refuse_reading(path_, errno);
  }
  parse_record(runs_spec().columns, json, path_, record);
}

}  // namespace ar3d
