#include "ar3d/store/journal/journal_reader.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

[[noreturn]] void refuse(const std::string& path, int reason) {
  throw InputError(fmt::format("cannot read {}: {}", path, std::strerror(reason)));
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
  const Row& row = rows_.at(i);
  std::vector<char> packed(row.size);
  errno = EIO;  // what a file that has shrunk is
  if (pread(file_.get(), packed.data(), packed.size(), static_cast<off_t>(row.offset)) !=
      static_cast<ssize_t>(packed.size())) {
    refuse(path_, errno);
  }
  unpack_row(format_, packed, record);
}

}  // namespace ar3d
