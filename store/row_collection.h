#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/store/columns/row_format.h"
#include "ar3d/store/study_identity.h"

namespace ar3d {

/// Represents the rows of one study, wherever they are: in journals and results files of its
/// shards, ranks and sessions. Whatever the order in which the files are added, the same rows stand
/// in it. Memory: about 60 bytes per row and 1 MB per file.
class RowCollection {
 public:
  /// @param format  outlives the collection.
  explicit RowCollection(const RowFormat& format);
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
  const StudyIdentity& identity() const;
  /// Returns the shards of the files, sorted, each once.
  const std::vector<Shard>& shards() const;
  /// Returns the entries of all sessions, in the order in which they began.
  const std::vector<EnvironmentEntry>& environment() const;

  std::size_t size() const;
  const RowKey& key(std::size_t place) const;
  /// Returns the file that has the row.
  const std::string& path(std::size_t place) const;
  std::optional<std::size_t> find(const RowKey& key) const;
  /// Writes a record. Of a journal it is cheap; of a results file it unpacks 512 records, but for
  /// the next ones in the order of the file.
  void read(std::size_t place, char* record) const;
  /// All records, in the order in which they stand in the files, so that each is unpacked once.
  void visit(const std::function<void(const char* record)>& visitor) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ar3d
