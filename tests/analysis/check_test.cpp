#include "ar3d/analysis/check.h"

#include <fmt/format.h>

#include <limits>

#include "analysis/synthetic.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d::testing {
namespace {

Results small_results() { return good_results({"diamond"}, {"cubic"}, 3, 2); }

/// What a change of the rows causes: the exit code, then kind and row of every finding.
template <class Change>
std::string found_after(Change change) {
  Results results = small_results();
  change(results.runs);
  const CheckVerdict verdict = check(results);
  std::string text = std::to_string(verdict.exit_code());
  for (const Finding& finding : verdict.findings) {
    text += fmt::format(", {} in {}", to_string(finding.kind), finding.row.value_or(99));
  }
  return text;
}
using Rows = std::vector<ar3d::RunRecord>;

TEST(Check, PassesWhenEveryRowIsProved) {
  const CheckVerdict verdict = check(small_results());
  EXPECT_EQ(verdict.exit_code(), 0);
  EXPECT_EQ(verdict.proved, 6u);
  EXPECT_THAT(summary(verdict), HasSubstr("PASS: 6 rows, 6 proved"));
}

TEST(Check, AnExtentThatTouchesTheBoundIsAllowedOneMoreIsNot) {
  for (const std::int64_t extent : {400, 401}) {
    EXPECT_EQ(found_after([&](Rows& rows) {
                rows[4].theorem_bound[2] = 400;
                rows[4].instance_bound[2] = -1;
                rows[4].extents[2] = extent;
              }),
              extent == 400 ? "0" : "4, theorem bound in 4");
  }
}

TEST(Check, EveryThingThatIsWrongWithARowIsFound) {
  EXPECT_EQ(found_after([](Rows& rows) { rows[1].instance_bound[0] = rows[1].extents[0] - 1; }),
            "4, instance bound in 1");
  EXPECT_EQ(found_after([](Rows& rows) { rows[2].violations = 1; }), "4, certificate in 2")
      << "although ok";
  EXPECT_EQ(found_after([](Rows& rows) { rows[0].violations = -1; }), "5, not certified in 0");
  EXPECT_EQ(found_after([](Rows& rows) { rows[0].extents[1] = -1; }), "5, not certified in 0");
  for (const double bound : {kMissing, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(found_after([&](Rows& rows) { rows[0].theorem_bound[1] = bound; }),
              "5, not certified in 0");
  }
  EXPECT_EQ(found_after([](Rows& rows) {
              rows[0].status = RunStatus::timeout;
              rows[5].violations = 1;
            }),
            "4, certificate in 5, unfinished in 0")
      << "a violation outweighs incomplete rows";
}

TEST(Check, VolumesBelowTheLeastPossibleAreViolations) {
  Results results = good_results({"diamond"}, {"cubic"}, 1, 1);
  results.runs[0].log2_volume = 10;
  for (const std::int64_t least : {1024, 1025}) {
    set_metric("volume_at_least", least, results.runs[0]);
    EXPECT_EQ(check(results).exit_code(), least == 1024 ? 0 : 4);
  }
  EXPECT_EQ(check(results).findings.at(0).message,
            "a volume of 2^10 is below volume_at_least, 1025");
}

TEST(Check, OnlyRefusedRowsAreNothingMeasuredSomeAreHarmless) {
  Results results = small_results();
  results.runs[0].status = RunStatus::refused;
  EXPECT_EQ(check(results).exit_code(), 0);
  EXPECT_EQ(check(results).refused, 1u);
  for (auto& run : results.runs) run.status = RunStatus::refused;
  EXPECT_EQ(check(results).exit_code(), 5);
}

TEST(Check, UnfinishedRowsAreIncomplete) {
  for (const RunStatus status :
       {RunStatus::timeout, RunStatus::out_of_memory, RunStatus::crashed}) {
    EXPECT_EQ(found_after([&](Rows& rows) { rows[3].status = status; }), "5, unfinished in 3");
  }
}

TEST(Check, RepetitionsMustGiveTheSameDrawingAndStandOnce) {
  const auto with_second = [](auto change) {
    return found_after([&](Rows& rows) {
      rows.push_back(rows[0]);
      rows.back().repetition = 1;
      change(rows.back());
    });
  };
  EXPECT_EQ(with_second([](auto&) {}), "0");
  EXPECT_EQ(with_second([](auto& run) { run.extents[0] -= 1; }), "4, not repeatable in 6");
  EXPECT_EQ(with_second([](auto& run) { run.drawing_hash = "another"; }), "4, not repeatable in 6")
      << "of equal extents";
  EXPECT_EQ(with_second([](auto& run) { run.repetition = 0; }), "5, duplicate in 6");
  EXPECT_EQ(with_second([](auto& run) {
              run.repetition = 0;
              run.phase = RunPhase::timing;
            }),
            "0");
}

TEST(Check, LongListsAreCutAndControlCharactersRemoved) {
  Results results = small_results();
  for (auto& run : results.runs) {
    run.status = RunStatus::crashed;
    run.message = "\x1b[31mred\nline\xff";
  }
  const std::string text = summary(check(results), 2);
  EXPECT_THAT(text, HasSubstr("and 5 more findings"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, HasSubstr("\uFFFD"));
}

}  // namespace
}  // namespace ar3d::testing
