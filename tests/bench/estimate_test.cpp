#include "ar3d/bench/run/estimate.h"

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/environment.h"
#include "support/parts.h"
#include "support/problem.h"
#include "support/test.h"

namespace ar3d::testing {
namespace {

StudyPlan plan_of(const std::string& top, const std::string& rest) {
  return plan_study(parse_study(top +
                                    "\nstudy = \"t\"\n[[sweep]]\nfamilies = \"random-cubic\"\n"
                                    "algorithms = \"grid\"\n" +
                                    rest,
                                "t.toml"));
}

std::string refusal(const StudyPlan& plan, double memory_bytes) {
  return problem([&] { refuse_impossible(plan, estimate(plan, 1), memory_bytes); }, "none");
}

TEST(Estimate, CountsCellsInstancesAndRows) {
  const StudyEstimate made =
      estimate(plan_of("",
                       "sizes = [20, 40]\ninstances = 3\nrepetitions = 2\n"
                       "timed_repetitions = { precision = 0.1, min = 6, max = 9 }\n"),
               2);
  ASSERT_EQ(made.cells.size(), 2u);
  EXPECT_EQ(made.cells[1].n, 40u);
  EXPECT_EQ(made.cells[1].instances, 3u);
  EXPECT_EQ(made.cells[1].rows, 3u * (2 + 6));
  EXPECT_EQ(made.rows, 2u * 3 * (2 + 6));
  EXPECT_EQ(made.optional_rows, 2u * 3 * 3);
  EXPECT_GT(made.wall_s, 0);
  EXPECT_GT(made.cells[1].total_s, made.cells[1].row_s);
  EXPECT_GT(made.cells[1].row_s, made.cells[1].draw_s);
}

// A model for every parameter would take longer than the study.
TEST(Estimate, ManyParametersShareModels) {
  std::string parameters;
  for (int k = 1; k <= 40; ++k) parameters += std::to_string(k) + ",";
  const StudyPlan plan = plan_study(parse_study(
      "study = \"t\"\n[[sweep]]\nfamilies = { family = \"generalised-petersen\", k = [" +
          parameters + "] }\nsizes = 400\nalgorithms = \"grid\"\n",
      "t.toml"));
  const StudyEstimate made = estimate(plan, 1);
  EXPECT_EQ(made.cells.size(), 40u);
  for (const CellEstimate& cell : made.cells) EXPECT_GT(cell.row_s, 0) << cell.curve.parameters;
}

// A million vertices are not drawn to know that they take longer and more memory.
TEST(Estimate, GrowsWithNFromSmallRuns) {
  const StudyEstimate made = estimate(plan_of("", "sizes = [1000, 1000000]\n"), 1);
  EXPECT_GE(made.cells[1].row_s, 999 * made.cells[0].row_s);
  EXPECT_LE(made.cells[1].row_s, 1e8 * made.cells[0].row_s);
  if (std::string(build_kind()) != "sanitised") {
    EXPECT_GT(made.cells[1].row_bytes, 5e7) << "at least 50 bytes per vertex";
    EXPECT_LT(made.cells[1].row_bytes, 2e10);
  }
  EXPECT_DOUBLE_EQ(made.largest_row_bytes, made.cells[1].row_bytes);
}

// Routed drawings take seconds: a plan that drew the largest would take as long as the study.
TEST(Estimate, SlowDrawingsAreKnownFromSmallerOnes) {
  const auto routed = [](const std::string& sweep) {
    return estimate(plan_study(parse_study("study = 't'\n[[sweep]]\n" + sweep, "t.toml")), 1);
  };
  const auto made = routed("families = 'random-cubic'\nsizes = 900\nalgorithms = 'routed-120'\n");
  EXPECT_EQ(made.calibration_n, 150u);
  EXPECT_GT(made.cells[0].row_s, 1.8) << "six times as long as the trial at least";
  // 150 times as long, in boxes of 180 times as many points; above 10,000 vertices the fall-back.
  const auto large =
      routed("families = 'random-4-regular'\nsizes = [1000, 9999, 20000]\nalgorithms = 'routed'\n");
  EXPECT_EQ(large.calibration_n, 1000u);
  EXPECT_GT(large.cells[1].row_s, 75 * large.cells[0].row_s);
  EXPECT_GT(large.cells[1].row_bytes, 5e8);
  EXPECT_LT(large.cells[2].row_s, large.cells[0].row_s);
}

TEST(Estimate, BytesHaveThreeDigitsAndAUnit) {
  EXPECT_EQ(bytes_text(0), "0 bytes");
  EXPECT_EQ(bytes_text(999), "999 bytes");
  EXPECT_EQ(bytes_text(999.6), "1 kB");
  EXPECT_EQ(bytes_text(6.1559e11), "616 GB");
  EXPECT_EQ(bytes_text(9.996e8), "1 GB");
  EXPECT_EQ(bytes_text(2.5e18), "2.5e+03 PB");
}

TEST(Estimate, RefusesWhatIsImpossible) {
  const StudyPlan large = plan_of("", "sizes = [100, 100000000]\n");
  EXPECT_EQ(refusal(large, 1e15), "none");
  expect_parts(
      {{refusal(large, 1e8), "grid (effort=1) on random-cubic n=100000000"},
       {refusal(large, 1e8), "but this machine has 100 MB"},
       {refusal(plan_of("budget = { row_time_s = 0.001 }", "sizes = 10000000\n"), 1e15),
        "budget.row_time_s gives 0.001 s"},
       {refusal(plan_of("budget = { row_memory_bytes = 1e6 }", "sizes = 10000000\n"), 1e15),
        "more than twice budget.row_memory_bytes (1 MB)"}});
  EXPECT_EQ(
      refusal(plan_of("budget = { row_time_s = 3600, row_memory_bytes = 4e9 }", "sizes = 1000\n"),
              1e15),
      "none");
  const StudyPlan three = plan_of("", "sizes = 1000000\ninstances = 3\n");
  const StudyEstimate four = estimate(three, 4);
  EXPECT_NO_THROW(refuse_impossible(three, four, 3.01 * four.largest_row_bytes));
  EXPECT_THROW(refuse_impossible(three, four, 2.9 * four.largest_row_bytes), InputError);
  EXPECT_GT(available_memory(), 1e8);
  EXPECT_LT(available_memory(), 1e15);
}

}  // namespace
}  // namespace ar3d::testing
