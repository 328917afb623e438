#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ar3d/store/columns/row_format.h"
#include "ar3d/store/columns/run_record.h"
#include "ar3d/store/columns/side_tables.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/study_identity.h"

namespace ar3d {

/// Returns the format of the rows of a study: the columns of /runs, /instances and /algorithms.
const RowFormat& run_format();

/// Appends a row of the journal's session. One call at a time. @throws JournalFull, InputError as
/// store_record.
void append_run(JournalWriter& journal, const RunRecord& run);

/// Describes a whole results file in memory.
struct Results : StudyIdentity {
  std::vector<EnvironmentEntry> environment;
  std::vector<RunRecord> runs;
};

/// Represents a results file, row by row. Memory: a few hundred rows.
class RunReader {
 public:
  /// @throws InputError as ResultsReader.
  explicit RunReader(const std::string& path);

  const StudyIdentity& identity() const { return reader_.identity(); }
  const std::vector<EnvironmentEntry>& environment() const { return reader_.environment(); }
  const std::vector<AlgorithmRecord>& algorithms() const { return algorithms_; }
  std::size_t size() const { return reader_.size(); }
  /// Returns row i with its bounds; cheap if i is near the one before. @throws InputError naming
  /// file and row.
  RunRecord read(std::size_t i);

 private:
  std::string path_;
  ResultsReader reader_;
  std::vector<AlgorithmRecord> algorithms_;
};

/// Describes the rows of one study, looked at one at a time, so that millions of them need not fit
/// into memory. What it points at outlives it.
struct RowView {
  const StudyIdentity* identity = nullptr;
  const std::vector<EnvironmentEntry>* environment = nullptr;
  std::size_t count = 0;
  std::int64_t planned = -1;  ///< rows that the study is complete with; -1: unknown
  /// Row 0 … count - 1, valid until the next call; cheap in increasing order. @throws InputError
  std::function<const RunRecord&(std::size_t row)> read;
  std::string file = "RESULTS.h5";  ///< what printed commands call the results file
};

RowView view_of(const Results& results);
RowView view_of(RunReader& reader);

/// @throws InputError as write_results of rows one at a time.
void write_results(const Results& results, const std::string& path);

/// @throws InputError as RunReader.
Results read_results(const std::string& path);

}  // namespace ar3d
