#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/store/columns/side_tables.h"
#include "ar3d/store/columns/study_identity.h"

namespace ar3d {

/// Describes a whole results file in memory.
struct Results : StudyIdentity {
  std::vector<EnvironmentEntry> environment;
  std::vector<RunRecord> runs;
};

/// Represents the rows of one study, wherever they are: in hand, in a results file, or in journals
/// and results files of its shards, ranks and sessions. They are looked at one at a time, so that
/// millions of them need not fit into memory.
class Rows {
 public:
  /// Rows in hand; they outlive it.
  // NOLINTNEXTLINE(google-explicit-constructor): results are rows
  Rows(const Results& results);
  /// Rows of a results file, in its order. Memory: a few hundred rows. @throws InputError as
  /// RunReader.
  explicit Rows(const std::string& results);
  /// Rows of files, journals and results files known by their content, in the order of their
  /// keys: the order of the files does not matter. Memory: about 60 bytes per row, 1 MB per file.
  /// @throws InputError naming the file if it cannot be read, is damaged, or is of another
  /// specification or source than the files before; naming files and column if a row is there twice
  /// and not the same.
  explicit Rows(const std::vector<std::string>& files);
  ~Rows();
  Rows(Rows&&) noexcept;
  Rows& operator=(Rows&&) noexcept;

  /// Returns the study's: of several files `created` is the earliest, `shard` and `planned_rows`
  /// are those of the first one.
  const StudyIdentity& identity() const { return identity_; }
  StudyIdentity& identity() { return identity_; }
  /// Returns the shards of the files, sorted, each once.
  const std::vector<Shard>& shards() const { return shards_; }
  /// Returns true if the files had different collected files: identity() has those of all.
  bool files_differ() const { return files_differ_; }
  /// Returns the entries of all sessions, in the order in which they began.
  const std::vector<EnvironmentEntry>& environment() const { return environment_; }

  std::size_t size() const { return size_; }
  /// Returns a row with its bounds, valid until the next call. Of a journal it is cheap; of a
  /// results file it unpacks 512 rows, unless the next one in the file is asked for.
  /// @throws InputError naming file and row.
  const RunRecord& run(std::size_t row) const;
  /// Writes its record. Sessions are numbered as in environment().
  void read(std::size_t row, char* record) const;
  /// Visits all records, in the order in which they stand in the files, so that each is unpacked
  /// once.
  void visit(const std::function<void(const char* record)>& visitor) const;

  // Of files, in the order of their keys:
  const RowKey& key(std::size_t row) const { return index_[row].key; }
  std::optional<std::size_t> find(const RowKey& key) const;
  /// Returns the file that has the row.
  const std::string& path(std::size_t row) const;
  /// Puts these rows, and no others, into this order; no row is found by its key from then on.
  void arrange(const std::vector<std::uint32_t>& rows);

  std::string file = "RESULTS.h5";  ///< what printed commands call the results file

 private:
  struct Source;
  struct FiledRow {
    RowKey key;
    std::uint32_t source = 0;
    std::uint32_t row = 0;
    auto in_files() const { return std::pair(source, row); }  // their order there
  };

  void add(const std::string& path);
  void number_sessions();
  void index_rows();
  void require_equal(std::size_t a, std::size_t b) const;

  StudyIdentity identity_;
  std::vector<Shard> shards_;
  bool files_differ_ = false;
  std::vector<EnvironmentEntry> environment_;
  std::vector<AlgorithmRecord> algorithms_;  // whose bounds rows get
  std::size_t size_ = 0;
  const Results* in_hand_ = nullptr;  // instead of files
  std::vector<Source> sources_;
  std::vector<FiledRow> index_;  // by key, or as arranged; empty: as they stand in the one file
  mutable std::vector<char> record_;
  mutable RunRecord run_;
};

/// @throws InputError as Rows of a results file.
Results read_results(const std::string& path);
Results in_memory(const Rows& rows);

/// Writes rows as a results file, in their order. @throws InputError as write_results of rows one at a time.
void write_results(const Rows& rows, const std::string& path);

}  // namespace ar3d
