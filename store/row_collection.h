#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/store/columns/row_key.h"
#include "ar3d/store/columns/study_identity.h"

namespace ar3d {

/// Represents the rows of one study, wherever they are: in journals and results files of its
/// shards, ranks and sessions. Whatever the order in which the files are added, the same rows stand
/// in it. Memory: about 60 bytes per row and 1 MB per file.
class RowCollection {
 public:
  RowCollection();
  ~RowCollection();
  RowCollection(RowCollection&&) noexcept;

  /// Adds a journal or a results file, told apart by their content.
  /// @throws InputError naming the file if it cannot be read, is damaged, or is of another
  /// specification or source than the files before.
  void add(const std::string& path);

  /// Ends the adding. @throws InputError if a row is there twice and not the same, naming the files
  /// and the column.
  void close();

  /// Returns the study's: `created` is the earliest of all files, `shard` and `planned_rows` are
  /// those of the first one.
  const StudyIdentity& identity() const { return identity_; }
  /// Returns the shards of the files, sorted, each once.
  const std::vector<Shard>& shards() const { return shards_; }
  /// Returns the entries of all sessions, in the order in which they began.
  const std::vector<EnvironmentEntry>& environment() const { return environment_; }

  std::size_t size() const { return rows_.size(); }
  const RowKey& key(std::size_t place) const { return rows_[place].key; }
  /// Returns the file that has the row.
  const std::string& path(std::size_t place) const;
  std::optional<std::size_t> find(const RowKey& key) const;
  /// Writes a record. Of a journal it is cheap; of a results file it unpacks 512 records, but for
  /// the next ones in the order of the file.
  void read(std::size_t place, char* record) const { read(rows_.at(place), record); }
  /// Visits all records, in the order in which they stand in the files, so that each is unpacked
  /// once.
  void visit(const std::function<void(const char* record)>& visitor) const;

 private:
  struct Source;
  struct FiledRow {
    RowKey key;
    std::uint32_t source = 0;
    std::uint32_t row = 0;
    bool operator<(const FiledRow& other) const;  // in the order of the files
  };

  void read(const FiledRow& row, char* record) const;
  void number_sessions();
  void index_rows();
  void require_equal(const FiledRow& a, const FiledRow& b) const;

  StudyIdentity identity_;
  std::vector<Shard> shards_;
  std::vector<EnvironmentEntry> environment_;
  std::vector<Source> sources_;
  std::vector<FiledRow> rows_;  // by key
};

}  // namespace ar3d
