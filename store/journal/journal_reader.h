#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/base/new_file.h"
#include "ar3d/store/journal/journal_format.h"

namespace ar3d {

/// Holds how it stands with a study: what a look at a journal's two ends tells, or at all of them.
struct JournalStatus {
  StudyIdentity identity;
  std::uint64_t rows = 0;
  std::uint64_t not_ok = 0;
  int writers = 0;  ///< processes that write now
  std::size_t journals = 0;
  bool complete() const {
    return identity.planned_rows >= 0 && rows >= static_cast<std::uint64_t>(identity.planned_rows);
  }
};

/// Reads the identity and the last record: the same time for any number of rows, also while the
/// journal is written. @throws InputError if it cannot be read or is no journal.
JournalStatus journal_status(const std::string& path);

/// Represents a journal's rows in the order in which they were made; may be written meanwhile: what
/// is whole when it is opened counts. Memory: 32 bytes per row, 16 once keys
/// are dropped.
class JournalReader {
 public:
  /// @throws InputError if it cannot be read, is no journal, has other columns, or is damaged
  /// (naming the offset).
  explicit JournalReader(std::string path);

  const StudyIdentity& identity() const { return identity_; }
  /// Returns the sessions, by number.
  const std::vector<std::vector<EnvironmentEntry>>& sessions() const { return sessions_; }
  std::size_t size() const { return rows_.size(); }
  /// Returns its key, while keys are held.
  RowKey key(std::size_t i) const { return keys_.at(i); }
  /// Holds no keys any more, for those who have an index of their own.
  void drop_keys() { keys_ = std::vector<RowKey>(); }
  /// Writes a record. @throws InputError
  void read(std::size_t i, char* record) const;

 private:
  std::string path_;
  Descriptor file_;
  StudyIdentity identity_;
  std::vector<std::vector<EnvironmentEntry>> sessions_;
  std::vector<RowKey> keys_;
  std::vector<std::pair<std::uint64_t, std::size_t>> rows_;  // offset and size of its JSON
};

}  // namespace ar3d
