#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ar3d/store/hdf5/results_file.h"

namespace ar3d {

/// Describes a whole results file in memory.
struct Results : StudyIdentity {
  std::vector<EnvironmentEntry> environment;
  std::vector<RunRecord> runs;
};

/// Describes the rows of one study, looked at one at a time, so that millions of them need not fit
/// into memory. What it points at outlives it.
struct RowView {
  const StudyIdentity* identity = nullptr;
  const std::vector<EnvironmentEntry>* environment = nullptr;
  std::size_t count = 0;
  std::int64_t planned = -1;  ///< rows that the study is complete with; -1: unknown
  /// Returns row 0 … count - 1, valid until the next call; cheap in increasing order. @throws
  /// InputError
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
