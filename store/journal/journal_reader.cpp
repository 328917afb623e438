// A journal's records, checked one after the other, and its rows by number. What a crash cut short
// at the end is left out; damage before it is told with its offset.
#include "ar3d/store/journal/journal_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/system_calls.h"

namespace ar3d {
namespace {

static_assert(std::endian::native == std::endian::little, "journals hold little-endian numbers");

constexpr std::size_t kHeadSize = sizeof(JournalHead);
constexpr std::size_t kMagicSize = sizeof(kJournalMagic);
constexpr std::size_t kReadAtOnce = std::size_t{1} << 20;

std::uint64_t checksum_of(std::span<const char> record, std::uint64_t offset) {
  const std::span<const char> covered = record.subspan(sizeof(JournalHead::checksum));
  return XXH3_64bits_withSeed(covered.data(), covered.size(), offset);
}

[[noreturn]] void refuse(const std::string& path, int reason) {
  throw InputError(fmt::format("cannot read {}: {}", path, std::strerror(reason)));
}

// A journal's bytes, read through a buffer that holds what was asked for last.
class JournalBytes {
 public:
  JournalBytes(int file, const std::string& path) : file_(file), path_(path) {
    struct stat status {};
    if (fstat(file, &status) != 0) refuse(path, errno);
    size_ = static_cast<std::uint64_t>(status.st_size);
  }
  std::uint64_t size() const { return size_; }

  /// The bytes [offset, offset + count), fewer at the end of the file.
  std::span<const char> at(std::uint64_t offset, std::size_t count) {
    if (offset < begin_ || offset + count > begin_ + buffer_.size()) {
      fill(offset, std::max(count, kReadAtOnce));
    }
    const std::size_t from = static_cast<std::size_t>(offset - begin_);
    return std::span<const char>(buffer_).subspan(from, std::min(count, buffer_.size() - from));
  }

  /// The record that begins at `offset`, if it is whole.
  std::optional<JournalRecord> record_at(std::uint64_t offset) {
    JournalRecord record;
    record.offset = offset;
    if (offset + kHeadSize > size_) return std::nullopt;
    const std::span<const char> head = at(offset, kHeadSize);
    if (head.size() < kHeadSize) return std::nullopt;
    std::memcpy(&record.head, head.data(), kHeadSize);
    const std::uint32_t payload_size = record.head.payload_size;
    if (payload_size > kLargestPayload || offset + kHeadSize + payload_size > size_) {
      return std::nullopt;
    }
    const std::span<const char> bytes = at(offset, kHeadSize + payload_size);
    if (bytes.size() < kHeadSize + payload_size) return std::nullopt;
    if (checksum_of(bytes, offset) != record.head.checksum) return std::nullopt;
    record.payload = bytes.subspan(kHeadSize);
    return record;
  }

 private:
  void fill(std::uint64_t offset, std::size_t count) {
    buffer_.resize(count);
    const std::size_t have = read_whole(file_, buffer_, offset);
    if (have < count && errno != 0) refuse(path_, errno);
    buffer_.resize(have);
    begin_ = offset;
  }

  int file_;
  const std::string& path_;
  std::uint64_t size_ = 0;
  std::uint64_t begin_ = 0;
  std::vector<char> buffer_;
};

std::optional<std::uint64_t> next_whole_record(JournalBytes& bytes, std::uint64_t from) {
  for (std::uint64_t offset = from; offset + kHeadSize <= bytes.size(); ++offset) {
    if (bytes.record_at(offset)) return offset;
  }
  return std::nullopt;
}

void require_magic(JournalBytes& bytes, const std::string& path) {
  const std::span<const char> start = bytes.at(0, kMagicSize);
  if (start.size() < kMagicSize || std::memcmp(start.data(), kJournalMagic, kMagicSize) != 0) {
    throw InputError(fmt::format("{} is not a journal of this version of ar3d", path));
  }
}

Descriptor open_to_read(const std::string& path) {
  Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) refuse(path, errno);
  return file;
}

void require_beginning(const StudyIdentity& identity, const std::string& path) {
  if (identity.spec_hash.empty()) {
    throw InputError(fmt::format("{} is a journal without a beginning", path));
  }
}

bool is_locked(int file) {
  struct flock range {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  return fcntl(file, F_OFD_GETLK, &range) == 0 && range.l_type != F_UNLCK;
}

}  // namespace

void frame_record(JournalHead head, std::span<const char> payload, std::uint64_t offset,
                  std::vector<char>& bytes) {
  expect(payload.size() <= kLargestPayload, "a journal's records are short");
  head.payload_size = static_cast<std::uint32_t>(payload.size());
  bytes.resize(kHeadSize + payload.size());
  std::memcpy(bytes.data(), &head, kHeadSize);
  std::copy(payload.begin(), payload.end(), bytes.begin() + kHeadSize);
  head.checksum = checksum_of(bytes, offset);
  std::memcpy(bytes.data(), &head.checksum, sizeof(head.checksum));
}

std::uint64_t scan_journal(int file, const std::string& path,
                           const std::function<bool(const JournalRecord&)>& visit) {
  JournalBytes bytes(file, path);
  require_magic(bytes, path);
  std::uint64_t offset = kMagicSize;
  while (const std::optional<JournalRecord> record = bytes.record_at(offset)) {
    if (!visit(*record)) return offset;
    offset += kHeadSize + record->head.payload_size;
  }
  if (const auto next = next_whole_record(bytes, offset + 1)) {
    throw InputError(fmt::format(
        "{}: damaged at byte {}: the record there fails its checksum, the next whole one begins at "
        "byte {}",
        path, offset, *next));
  }
  return offset;
}

JournalHead last_journal_record(int file, const std::string& path) {
  JournalBytes bytes(file, path);
  require_magic(bytes, path);
  JournalHead last;
  for (std::uint64_t window = kReadAtOnce / 16;; window *= 4) {
    const bool whole_file = window + kMagicSize >= bytes.size();
    const std::uint64_t from = whole_file ? kMagicSize : bytes.size() - window;
    bool found = false;
    for (auto offset = next_whole_record(bytes, from); offset;
         offset = next_whole_record(bytes, *offset + kHeadSize + last.payload_size)) {
      found = true;
      last = bytes.record_at(*offset)->head;
    }
    if (found || whole_file) return last;
  }
}

JournalStatus journal_status(const std::string& path, const RowFormat& format) {
  const Descriptor file = open_to_read(path);
  JournalStatus status;
  scan_journal(file.get(), path, [&](const JournalRecord& record) {
    status.identity = parse_identity(record.payload, format, path);
    return false;  // the first record is all that is asked for
  });
  require_beginning(status.identity, path);
  const JournalHead last = last_journal_record(file.get(), path);
  status.rows = last.rows;
  status.not_ok = last.not_ok;
  status.is_written = is_locked(file.get());
  return status;
}

JournalReader::JournalReader(std::string path, const RowFormat& format)
    : path_(std::move(path)), format_(format), file_(open_to_read(path_)) {
  whole_bytes_ = scan_journal(file_.get(), path_, [this](const JournalRecord& record) {
    note(record);
    return true;
  });
  require_beginning(identity_, path_);
}

void JournalReader::note(const JournalRecord& record) {
  const auto session_entries = [&] { return parse_session(record.payload, path_); };
  switch (record.head.kind) {
    case JournalKind::identity:
      identity_ = parse_identity(record.payload, format_, path_);
      return;
    case JournalKind::session:
      sessions_.push_back(session_entries());
      return;
    case JournalKind::session_end:
      if (sessions_.empty()) {
        throw InputError(fmt::format("{}: a session ends that has not begun", path_));
      }
      for (EnvironmentEntry& entry : session_entries()) {
        sessions_.back().push_back(std::move(entry));
      }
      return;
    case JournalKind::row:
      rows_.push_back({packed_row_key(format_, record.payload), record.offset + sizeof(JournalHead),
                       record.head.payload_size});
      return;
  }
}

void JournalReader::read(std::size_t i, char* record) const {
  const PackedRow& row = rows_.at(i);
  std::vector<char> packed(row.size);
  errno = EIO;  // what a file that has shrunk is
  if (pread(file_.get(), packed.data(), packed.size(), static_cast<off_t>(row.offset)) !=
      static_cast<ssize_t>(packed.size())) {
    refuse(path_, errno);
  }
  unpack_row(format_, packed, record);
}

}  // namespace ar3d
