// Appends rows to a journal. A row is acknowledged once its write has returned, and what a crash
// may leave is one record cut short, which the next writer cuts off.
#include "ar3d/store/journal/journal_writer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>

#include "ar3d/base/system_calls.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

void require_same(const StudyIdentity& journal, const StudyIdentity& study,
                  const std::string& path) {
  const auto compare = [&](const char* what, const std::string& theirs, const std::string& ours) {
    if (theirs != ours) {
      throw InputError(fmt::format("{}: its {} is {}, not {}", path, what, theirs, ours));
    }
  };
  const auto shard = [](const Shard& s) { return fmt::format("{}/{}", s.index, s.count); };
  compare("specification", journal.spec_hash, study.spec_hash);
  compare("program's source", journal.source(), study.source());
  compare("shard", shard(journal.shard), shard(study.shard));
}

bool has_no_name(int file) {
  struct stat status {};
  return fstat(file, &status) == 0 && status.st_nlink == 0;
}

}  // namespace

JournalWriter::JournalWriter(const std::string& path, const StudyIdentity& identity)
    : path_(path), record_(run_record_size()) {
  create_if_missing(identity);
  lock();
  read_existing(identity);
  syncer_ = std::thread([this] { sync_every_second(); });
}

JournalWriter::~JournalWriter() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  wake_.notify_one();
  syncer_.join();
  fdatasync(file_.get());
}

// The identity is in the file before it gets its name, so that no crash leaves half a beginning.
void JournalWriter::create_if_missing(const StudyIdentity& identity) {
  if (access(path_.c_str(), F_OK) != 0) {
    const std::string text = identity_text(identity);
    frame_record({.kind = kIdentity, .payload = text}, line_);
    create_file_atomically(path_, line_);
  }
  file_ = Descriptor(open(path_.c_str(), O_RDWR | O_APPEND | O_CLOEXEC));
  if (file_.get() < 0) refuse_writing(path_, errno);
}

// The lock belongs to the open file: it lasts until the last process that has it is gone, which may
// be a worker that dies with its parent a moment later.
void JournalWriter::lock() {
  struct flock range {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  for (int tries = 0; tries < 20; ++tries) {
    if (fcntl(file_.get(), F_OFD_SETLK, &range) == 0) {
      if (has_its_name(file_.get(), path_)) return;
      throw InputError(fmt::format("{} is gone: another process has finished it", path_));
    }
    if (errno != EACCES && errno != EAGAIN) refuse_writing(path_, errno);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  throw InputError(fmt::format("{} is being written by another process", path_));
}

void JournalWriter::read_existing(const StudyIdentity& identity) {
  end_ = scan_journal(file_.get(), path_, [&](const JournalRecord& record) {
    last_ = record;
    if (record.kind == kIdentity) {
      require_same(parse_identity(record.payload, path_), identity, path_);
    }
    if (record.kind == kSession) ++session_;
    return true;
  });
  const off_t size = lseek(file_.get(), 0, SEEK_END);
  if (size < 0) refuse_writing(path_, errno);
  bytes_cut_ = static_cast<std::uint64_t>(size) - end_;
  if (bytes_cut_ > 0) {
    keep_what_is_cut();
    if (ftruncate(file_.get(), static_cast<off_t>(end_)) != 0) refuse_writing(path_, errno);
  }
  if (fsync(file_.get()) != 0) refuse_writing(path_, errno);
}

// One record cut short is what every crash leaves behind, or zeros, which a loss of power may
// leave. Anything else, a whole record that stands where it does not belong for one, may be rows
// that another process has acknowledged.
void JournalWriter::keep_what_is_cut() {
  std::string bytes(bytes_cut_, '\0');
  if (read_whole(file_.get(), bytes, end_) < bytes.size()) {
    refuse_writing(path_, errno != 0 ? errno : EIO);
  }
  if (is_cut_short(bytes) || bytes.find_first_not_of('\0') == bytes.npos) return;
  for (int number = 1; cut_file_.empty(); ++number) {
    const std::string path = fmt::format("{}.cut-{}", path_, number);
    if (create_file_atomically(path, bytes)) cut_file_ = path;
  }
}

void JournalWriter::begin_session(const std::vector<EnvironmentEntry>& environment) {
  json_ = session_text(environment);
  write_line({kSession, last_.rows, last_.not_ok});
  ++session_;
}

void JournalWriter::end_session(const std::vector<EnvironmentEntry>& environment) {
  json_ = session_text(environment);
  write_line({kSessionEnd, last_.rows, last_.not_ok});
  sync();
}

void JournalWriter::append(const RunRecord& run) {
  static const Column& session = run_column("session");
  expect(session_ >= 0, "a journal's rows belong to a session");
  store_record(run, record_.data());
  std::memcpy(record_.data() + session.offset, &session_, sizeof(session_));
  append_record(record_.data());
}

void JournalWriter::append_record(const char* record) {
  static const Column& column = run_column("status");
  json_.clear();
  write_record(runs_spec().columns, record, json_);
  const std::string status = text_of(column, record);
  const bool is_ok = status == "ok" || status == "measured";
  write_line({kRow, last_.rows + 1, last_.not_ok + (is_ok ? 0 : 1)});
}

// Of a line with json_ as its payload.
void JournalWriter::write_line(JournalRecord record) {
  if (const int reason = sync_error_) fail(reason);
  put_back_if_deleted();
  record.offset = end_;
  record.payload = json_;
  frame_record(record, line_);
  if (const std::size_t written = write_whole(file_.get(), line_); written < line_.size()) {
    const int reason = errno;
    // Nothing is cut off where another process has written meanwhile. Should this fail as well, the
    // next writer cuts the half record off.
    const off_t size = lseek(file_.get(), 0, SEEK_END);
    if (size >= 0 && size <= static_cast<off_t>(end_ + written)) {
      [[maybe_unused]] const int cut = ftruncate(file_.get(), static_cast<off_t>(end_));
    }
    fail(reason);
  }
  // The file is opened for appending: a write that ends elsewhere began behind bytes of another
  // process, and this record does not count there.
  const off_t written_to = lseek(file_.get(), 0, SEEK_CUR);
  if (written_to != static_cast<off_t>(end_ + line_.size())) {
    throw JournalFull(
        fmt::format("{} is being written by another process, too: its file system keeps no locks; "
                    "this process ends, so that one is left",
                    path_));
  }
  last_ = record;
  end_ += line_.size();
  unsynced_ = true;
}

// The file is there as long as it is open, but it would not be found any more.
void JournalWriter::put_back_if_deleted() {
  if (!deleted_) return;
  std::vector<char> bytes(end_);
  if (read_whole(file_.get(), bytes, 0) < bytes.size()) fail(errno != 0 ? errno : EIO);
  if (!create_file_atomically(path_, bytes)) {
    throw JournalFull(fmt::format("{} was replaced by another file while rows went there", path_));
  }
  throw JournalFull(fmt::format("{} was deleted while rows went there; it is back with {} of them",
                                path_, last_.rows));
}

void JournalWriter::sync() {
  if (has_no_name(file_.get())) deleted_ = true;
  put_back_if_deleted();
  unsynced_ = false;
  if (fdatasync(file_.get()) != 0) sync_error_ = errno;
  if (const int reason = sync_error_) fail(reason);
}

void JournalWriter::sync_every_second() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ends_) {
    wake_.wait_for(lock, std::chrono::seconds(1));
    if (has_no_name(file_.get())) deleted_ = true;
    if (unsynced_.exchange(false) && fdatasync(file_.get()) != 0) sync_error_ = errno;
  }
}

void JournalWriter::fail(int reason) const {
  throw JournalFull(fmt::format("cannot write {}: {}", path_, std::strerror(reason)));
}

}  // namespace ar3d
