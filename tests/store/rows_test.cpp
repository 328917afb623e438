#include "ar3d/store/rows.h"

#include "ar3d/bench/run/session.h"
#include "ar3d/store/columns/run_columns.h"
#include "store/sample_runs.h"
#include "support/problem.h"
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

Rows collected(const std::vector<Results>& files) {
  const ScratchDirectory scratch;
  std::vector<std::string> paths;
  for (const Results& results : files) {
    const std::string path = scratch.path(std::to_string(scratch.entries()));
    write_results(results, path);
    paths.push_back(path);
  }
  return Rows(paths);
}

TEST(Rows, IsVisitedInTheOrderOfItsFiles) {
  const Rows rows = collected({rows_from(0, 1500), rows_from(1000, 1500)});  // 500 in both
  std::vector<std::string> keys, expected;
  rows.visit([&keys](const char* record) { keys.push_back(load_record(record).row_key); });
  for (const RunRecord& run : rows_from(0, 2500).runs) expected.push_back(run.row_key);
  EXPECT_EQ(keys, expected);
  for (std::size_t index = 1; index < rows.size(); ++index) {
    EXPECT_LT(rows.key(index - 1), rows.key(index));
  }
}

TEST(Rows, RefusesARowThatIsThereTwiceAndNotTheSame) {
  Results other = rows_from(0, 1500);
  other.runs[1234].violations = 1;
  EXPECT_THAT(problem([&] {
                collected({rows_from(0, 1500), other});
              }),
              HasSubstr("differs in its violations"));
}

}  // namespace
}  // namespace ar3d::testing
