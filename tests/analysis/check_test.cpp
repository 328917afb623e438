#include "ar3d/analysis/check.h"

#include <limits>

#include "analysis/synthetic.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d::testing {
namespace {

Results small_results() { return good_results({"diamond"}, {"cubic"}, 3, 2); }

/// The single finding that the change of one row causes.
Finding only_finding(const Results& results) {
  const CheckVerdict verdict = check(results);
  EXPECT_EQ(verdict.findings.size(), 1u) << summary(verdict);
  return verdict.findings.at(0);
}

TEST(Check, PassesWhenEveryRowIsProved) {
  const Results results = small_results();
  const CheckVerdict verdict = check(results);
  EXPECT_EQ(verdict.exit_code(), 0);
  EXPECT_EQ(verdict.proved, 6u);
  EXPECT_THAT(summary(verdict), HasSubstr("PASS: 6 rows, 6 proved"));
}

TEST(Check, AnExtentThatTouchesTheBoundIsAllowedOneMoreIsNot) {
  Results results = small_results();
  auto& run = results.runs[4];
  run.theorem_bound[2] = 400;
  run.instance_bound[2] = -1;
  run.extents[2] = 400;
  EXPECT_EQ(check(results).exit_code(), 0);
  run.extents[2] = 401;
  const Finding finding = only_finding(results);
  EXPECT_EQ(finding.kind, FindingKind::theorem_bound);
  EXPECT_EQ(finding.row, 4u);
  EXPECT_EQ(check(results).exit_code(), 4);
}

TEST(Check, TheInstanceBoundIsCheckedToo) {
  Results results = small_results();
  results.runs[1].instance_bound[0] = results.runs[1].extents[0] - 1;
  EXPECT_EQ(only_finding(results).kind, FindingKind::instance_bound);
  EXPECT_EQ(check(results).exit_code(), 4);
}

TEST(Check, VolumesBelowTheLeastPossibleAreViolations) {
  Results results = good_results({"diamond"}, {"cubic"}, 1, 1);
  results.runs[0].log2_volume = 10;
  for (const std::int64_t least : {1024, 1025}) {
    run_column("volume_at_least").load(reinterpret_cast<const char*>(&least), results.runs[0]);
    EXPECT_EQ(check(results).exit_code(), least == 1024 ? 0 : 4);
  }
  EXPECT_EQ(only_finding(results).message, "a volume of 2^10 is below volume_at_least, 1025");
}

TEST(Check, AViolatedCertificateIsExit4AndNamesTheCommand) {
  Results results = small_results();
  results.runs[2].status = RunStatus::violated;
  results.runs[2].violations = 3;
  results.runs[2].message = "crossing of edges 4 and 7";
  const CheckVerdict verdict = check(results);
  EXPECT_EQ(verdict.exit_code(), 4);
  const std::string text = summary(verdict);
  EXPECT_THAT(text, HasSubstr("crossing of edges 4 and 7"));
  EXPECT_THAT(text, HasSubstr("ar3d generate cubic -n 32 --seed 32000 | ar3d draw"));
}

TEST(Check, AnOkRowWithViolationsIsNotTrusted) {
  Results results = small_results();
  results.runs[2].violations = 1;
  EXPECT_EQ(only_finding(results).kind, FindingKind::certificate);
}

TEST(Check, ZeroRowsAreNeverAPass) {
  const Results results;
  EXPECT_EQ(check(results).exit_code(), 5);
  EXPECT_THAT(summary(check(results)), HasSubstr("nothing measured: the file has no rows"));
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
    Results results = small_results();
    results.runs[3].status = status;
    EXPECT_EQ(only_finding(results).kind, FindingKind::unfinished);
    EXPECT_EQ(check(results).exit_code(), 5);
    EXPECT_EQ(check(results).incomplete_rows, 1u);
  }
}

TEST(Check, MissingCertificateExtentOrBoundIsIncomplete) {
  Results uncertified = small_results();
  uncertified.runs[0].violations = -1;
  EXPECT_EQ(only_finding(uncertified).kind, FindingKind::not_certified);
  Results no_extent = small_results();
  no_extent.runs[0].extents[1] = -1;
  EXPECT_EQ(only_finding(no_extent).kind, FindingKind::not_certified);
  for (const double bound : {kMissing, std::numeric_limits<double>::infinity()}) {
    Results no_bound = small_results();
    no_bound.runs[0].theorem_bound[1] = bound;
    EXPECT_EQ(only_finding(no_bound).kind, FindingKind::not_certified);
    EXPECT_EQ(check(no_bound).exit_code(), 5);
  }
}

TEST(Check, AViolationOutweighsIncompleteRows) {
  Results results = small_results();
  results.runs[0].status = RunStatus::timeout;
  results.runs[5].violations = 1;
  const CheckVerdict verdict = check(results);
  EXPECT_EQ(verdict.exit_code(), 4);
  EXPECT_EQ(verdict.findings.front().row, 5u);
}

TEST(Check, RepetitionsMustGiveTheSameDrawing) {
  Results results = small_results();
  results.runs.push_back(good_run("diamond", "cubic", 16, 0, 1));
  EXPECT_EQ(check(results).exit_code(), 0);
  results.runs.back().extents[0] -= 1;
  EXPECT_EQ(only_finding(results).kind, FindingKind::not_repeatable);
  EXPECT_EQ(check(results).exit_code(), 4);
}

TEST(Check, EqualExtentsDoNotExcuseAnotherDrawing) {
  Results results = small_results();
  results.runs.push_back(good_run("diamond", "cubic", 16, 0, 1));
  results.runs.back().drawing_hash = "another";
  EXPECT_EQ(only_finding(results).kind, FindingKind::not_repeatable);
}

TEST(Check, TheSameMeasurementTwiceIsADuplicate) {
  Results results = small_results();
  results.runs.push_back(results.runs[0]);
  results.runs.back().phase = RunPhase::timing;
  EXPECT_EQ(check(results).exit_code(), 0);
  results.runs.back().phase = RunPhase::metrics;
  EXPECT_EQ(only_finding(results).kind, FindingKind::duplicate);
  EXPECT_EQ(check(results).exit_code(), 5);
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
