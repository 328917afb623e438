// Rows of a study as run records, wherever they are kept: one after the other, or all in memory.
#include "ar3d/store/run_storage.h"

#include <memory>

#include "ar3d/store/columns/run_columns.h"

namespace ar3d {

void write_results(const Results& results, const std::string& path) {
  const auto read = [&](std::size_t i, char* record) { store_record(results.runs[i], record); };
  write_results(results, results.environment, results.runs.size(), read, path);
}

Results read_results(const std::string& path) {
  RunReader reader(path);
  Results results;
  static_cast<StudyIdentity&>(results) = reader.identity();
  results.environment = reader.environment();
  results.runs.reserve(reader.size());
  for (std::size_t i = 0; i < reader.size(); ++i) results.runs.push_back(reader.read(i));
  return results;
}

RowView view_of(const Results& results) {
  return {&results, &results.environment, results.runs.size(), results.planned_rows,
          [&results](std::size_t row) -> const RunRecord& { return results.runs[row]; }};
}

RowView view_of(RunReader& reader) {
  const auto run = std::make_shared<RunRecord>();
  return {&reader.identity(), &reader.environment(), reader.size(), reader.identity().planned_rows,
          [&reader, run](std::size_t row) -> const RunRecord& {
            *run = reader.read(row);
            return *run;
          }};
}

}  // namespace ar3d
