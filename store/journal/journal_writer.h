#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/store/columns/run_record.h"
#include "ar3d/store/journal/journal_format.h"

namespace ar3d {

/// Says that the journal cannot take another row (the disk is full, say, or another process appends
/// to it where the file system keeps no locks). It is whole; the study can go on later.
class JournalFull : public InputError {
 public:
  using InputError::InputError;
};

/// Appends rows to a study's journal. One writer a journal: the file is locked while it lives.
///
/// A row is acknowledged when append() returns: one write(2) has put it into the file, and neither
/// the death of the process nor of any other can take it away. A second later at most it is on the
/// disk (fdatasync by a thread of the writer's own) and survives a loss of power. That thread also
/// notices that the journal was deleted; it is put back then, and takes no more rows.
class JournalWriter {
 public:
  /// Creates the journal, or continues it: cuts off a record that a crash cut short.
  /// @throws InputError if another process writes it, it is damaged, it is of another study, shard
  /// or source, or it cannot be written.
  JournalWriter(const std::string& path, const StudyIdentity& identity);
  ~JournalWriter();
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /// Says where the rows to come are made. Before the first row.
  void begin_session(const std::vector<EnvironmentEntry>& environment);
  /// Writes what is known only at the end of the session, such as the load.
  void end_session(const std::vector<EnvironmentEntry>& environment);

  /// Appends a row of this session. One call at a time.
  /// @throws JournalFull: the row is not in the journal, all before it are; InputError as
  /// store_record.
  void append(const RunRecord& run);

  /// Appends a record as it is; its session counts this journal's, from 0.
  void append_record(const char* record);

  /// Puts everything appended on the disk. @throws JournalFull
  void sync();

  std::uint64_t rows() const { return last_.rows; }
  /// Returns bytes of an unfinished record that opening the journal cut off.
  std::uint64_t bytes_cut() const { return bytes_cut_; }
  /// Returns the file beside the journal that they are kept in; empty if they were the beginning of
  /// one record, which a crash leaves behind, not acknowledged.
  const std::string& cut_file() const { return cut_file_; }

 private:
  void create_if_missing(const StudyIdentity& identity);
  void lock();
  void read_existing(const StudyIdentity& identity);
  void keep_what_is_cut();
  void put_back_if_deleted();
  void write_line(JournalRecord record);
  void sync_every_second();
  [[noreturn]] void fail(int reason) const;

  std::string path_;
  Descriptor file_;
  std::uint64_t end_ = 0;
  std::uint64_t bytes_cut_ = 0;
  std::string cut_file_;
  std::int64_t session_ = -1;
  JournalRecord last_;
  std::vector<char> record_;
  std::string json_;
  std::string line_;

  std::atomic<bool> unsynced_ = false;
  std::atomic<int> sync_error_ = 0;
  std::atomic<bool> deleted_ = false;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread syncer_;
};

}  // namespace ar3d
