#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/store/columns/run_columns.h"
#include "bench/in_memory.h"

namespace ar3d::testing {
namespace {

std::vector<RunRecord> study_rows() {
  return run_study(parse_study("study = \"t\"\n[[sweep]]\nfamilies = [\"random-cubic\", "
                               "{ family = \"generalised-petersen\", k = [2, 3] }]\nsizes = [20, "
                               "40]\nalgorithms = [\"grid\", { algorithm = \"diamond\", effort = "
                               "[0, 2] }]\nrepetitions = 2\ninstances = 2\n",
                               "t.toml"),
                   {.workers = 1})
      .runs;
}

std::map<std::size_t, std::vector<std::string>> differing(const std::vector<RunRecord>& rows,
                                                          const std::vector<std::size_t>& indices) {
  std::map<std::size_t, std::vector<std::string>> columns;
  for (const std::size_t index : indices) {
    const RunRecord now = replayed(rows[index], {.study = Study()});
    EXPECT_NE(now.status, RunStatus::violated);
    columns[index] = differing_columns(rows[index], now);
  }
  return columns;
}

TEST(SelfCheck, EveryRowOfAStudyIsReproduced) {
  const std::vector<RunRecord> rows = study_rows();
  const auto found = differing(rows, sample_of_rows(rows, rows.size(), 1));
  EXPECT_EQ(found.size(), rows.size());
  for (const auto& [row, columns] : found) EXPECT_THAT(columns, IsEmpty()) << row;
}

TEST(SelfCheck, FindsWhatWasChanged) {
  std::vector<RunRecord> rows = study_rows();
  rows[3].extents[1] += 1;
  rows[5].drawing_hash[7] = rows[5].drawing_hash[7] == 'a' ? 'b' : 'a';
  rows[7].row_key[0] = rows[7].row_key[0] == 'a' ? 'b' : 'a';
  rows[9].instance_index += 1;
  EXPECT_THAT(
      differing(rows, {1, 3, 5, 7, 9}),
      ElementsAre(::testing::Pair(1, IsEmpty()), ::testing::Pair(3, ElementsAre("extent_y")),
                  ::testing::Pair(5, ElementsAre("drawing_hash")),
                  ::testing::Pair(7, ElementsAre("row_key")),
                  ::testing::Pair(9, Contains("row_key"))));
}

TEST(SelfCheck, TheSampleIsAFunctionOfItsSeedAndLeavesOutWhatCannotBeReplayed) {
  std::vector<RunRecord> rows(1000);
  for (RunRecord& run : rows) run.status = RunStatus::ok;
  for (std::size_t i = 0; i < rows.size(); i += 2) rows[i].status = RunStatus::timeout;
  const auto sample = sample_of_rows(rows, 100, 7);
  ASSERT_EQ(sample.size(), 100u);
  EXPECT_TRUE(std::is_sorted(sample.begin(), sample.end()));
  EXPECT_EQ(std::adjacent_find(sample.begin(), sample.end()), sample.end()) << "no row twice";
  for (const std::size_t index : sample) EXPECT_EQ(index % 2, 1u);
  EXPECT_EQ(sample, sample_of_rows(rows, 100, 7));
  EXPECT_NE(sample, sample_of_rows(rows, 100, 8));
  EXPECT_LT(sample.front(), 200u) << "from everywhere";
  EXPECT_GT(sample.back(), 800u);
  EXPECT_EQ(sample_of_rows(rows, 5000, 7).size(), 500u);
}

}  // namespace
}  // namespace ar3d::testing
