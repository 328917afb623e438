#include "ar3d/analysis/rows.h"

#include <memory>

namespace ar3d {

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
