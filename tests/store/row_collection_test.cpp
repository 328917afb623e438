#include "ar3d/store/row_collection.h"

#include "ar3d/base/error.h"
#include "ar3d/bench/run/describe_study.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/run_storage.h"
#include "store/sample_runs.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

// Rows whose keys do not grow along the file, as those of a study do not.
Results rows_from(std::int64_t first, std::int64_t count) {
  Results results = sample_results(0);
  results.environment = {{"started", "2024-01-01T00:00:00+00:00", 0}};
  for (std::int64_t i = first; i < first + count; ++i) {
    results.runs.push_back(sample_run(i * 7919 % 10007));
    results.runs.back().session = 0;
  }
  return results;
}

std::vector<std::string> visited_keys(const RowCollection& rows) {
  std::vector<std::string> keys;
  rows.visit([&keys](const char* record) { keys.push_back(load_record(record).row_key); });
  return keys;
}

TEST(RowCollection, IsVisitedInTheOrderOfItsFiles) {
  const ScratchDirectory scratch;
  const Results a = rows_from(0, 1500);
  const Results b = rows_from(1000, 1500);  // 500 rows are in both
  write_results(a, scratch.path("a.h5"));
  write_results(b, scratch.path("b.h5"));
  RowCollection rows;
  rows.add(scratch.path("a.h5"));
  rows.add(scratch.path("b.h5"));
  rows.close();
  std::vector<std::string> expected;
  for (const RunRecord& run : rows_from(0, 2500).runs) expected.push_back(run.row_key);
  EXPECT_EQ(visited_keys(rows), expected);
  for (std::size_t place = 1; place < rows.size(); ++place) {
    EXPECT_LT(rows.key(place - 1), rows.key(place));
  }
}

TEST(RowCollection, RefusesARowThatIsThereTwiceAndNotTheSame) {
  const ScratchDirectory scratch;
  write_results(rows_from(0, 1500), scratch.path("a.h5"));
  Results b = rows_from(0, 1500);
  b.runs[1234].violations = 1;
  write_results(b, scratch.path("b.h5"));
  RowCollection rows;
  rows.add(scratch.path("a.h5"));
  rows.add(scratch.path("b.h5"));
  EXPECT_THROW(rows.close(), InputError);
}

}  // namespace
}  // namespace ar3d::testing
