#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ar3d/store/columns/row_format.h"
#include "ar3d/store/columns/run_record.h"
#include "ar3d/store/columns/side_tables.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/study_identity.h"

namespace ar3d {

/// The format of the rows of a study: the columns of /runs, /instances and /algorithms.
const RowFormat& run_format();

/// A row of the journal's session. One call at a time. @throws JournalFull, InputError as
/// store_record.
void append_run(JournalWriter& journal, const RunRecord& run);

/// A whole results file in memory.
struct Results : StudyIdentity {
  std::vector<EnvironmentEntry> environment;
  std::vector<RunRecord> runs;
};

/// A results file, row by row. Memory: a few hundred rows.
class RunReader {
 public:
  /// @throws InputError as ResultsReader.
  explicit RunReader(const std::string& path);

  const StudyIdentity& identity() const { return reader_.identity(); }
  const std::vector<EnvironmentEntry>& environment() const { return reader_.environment(); }
  const std::vector<AlgorithmRecord>& algorithms() const { return algorithms_; }
  std::size_t size() const { return reader_.size(); }
  /// Row i with its bounds; cheap if i is near the one before. @throws InputError naming file and
  /// row.
  RunRecord read(std::size_t i);

 private:
  std::string path_;
  ResultsReader reader_;
  std::vector<AlgorithmRecord> algorithms_;
};

/// @throws InputError as write_results of rows one at a time.
void write_results(const Results& results, const std::string& path);

/// @throws InputError as RunReader.
Results read_results(const std::string& path);

}  // namespace ar3d
