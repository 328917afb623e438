#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <optional>

#include "ar3d/base/error.h"
#include "ar3d/store/journal/journal_format.h"

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

// A journal's bytes, read through a buffer that holds what was asked for last.
class JournalBytes {
 public:
  JournalBytes(int file, const std::string& path) : file_(file), path_(path) {
    struct stat status {};
    if (fstat(file, &status) != 0) fail();
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
  [[noreturn]] void fail() const {
    throw InputError(fmt::format("cannot read {}: {}", path_, std::strerror(errno)));
  }

  void fill(std::uint64_t offset, std::size_t count) {
    buffer_.resize(count);
    std::size_t have = 0;
    while (have < count) {
      const ssize_t got =
          pread(file_, buffer_.data() + have, count - have, static_cast<off_t>(offset + have));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) fail();
      if (got == 0) break;
      have += static_cast<std::size_t>(got);
    }
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

}  // namespace ar3d
