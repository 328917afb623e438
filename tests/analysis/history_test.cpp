// Histories: what becomes one line, what is left out, and what the page says.
#include "ar3d/analysis/history/history.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/synthetic.h"
#include "ar3d/base/error.h"
#include "ar3d/store/columns/side_tables.h"
#include "support/problem.h"
#include "support/program.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

constexpr std::size_t kCommits = 16;

std::string hash_of(std::size_t commit) { return fmt::format("{:040x}", 0xabc000 + commit); }

/// Two families at one size, timed; 10 % slower on family "b" from commit 8 on.
Results commit_results(std::size_t commit) {
  Results results = good_results({"grid"}, {"a", "b"}, 1, 3);
  results.study_id = "tiny";
  results.source_hash = hash_of(commit);
  results.created = "2026-01-01T00:00:00Z";
  results.environment = {{"cpu", "A", 1}, {"cores", "2", 1}, {"load_before", "0.10", 1}};
  RandomStream random(7, commit);
  for (RunRecord& run : results.runs) {
    run.wall_s = 1e-3 * (1 + 0.002 * normal(random));
    if (run.family == "b" && commit >= 8) run.wall_s *= 1.1;
    run.counted_instructions = 1000000;
    run.session = 1;
  }
  return results;
}

/// Writes the commits into a folder, each changed by `change`.
template <class Change>
void write_history(const ScratchDirectory& scratch, Change change) {
  for (std::size_t commit = 0; commit < kCommits; ++commit) {
    Results results = commit_results(commit);
    change(commit, results);
    const std::string name =
        history_file_name(static_cast<std::int64_t>(100 + commit), results.source_hash.substr(28),
                          results, results.environment);
    write_results(results, scratch.path(name));
  }
}

History read(const ScratchDirectory& scratch) { return read_history(scratch.path(""), {}); }

const HistoryLine& line_of(const History& history, const std::string& family, Measure measure) {
  for (const HistoryLine& line : history.lines) {
    if (line.cell.curve.family == family && line.measure == measure) return line;
  }
  throw InputError("no such line");
}

std::size_t num_changes(const History& history) {
  std::size_t changes = 0;
  for (const HistoryLine& line : history.lines) changes += line.changes.size();
  return changes;
}

TEST(History, ASeededStepIsFoundWithItsCommitsEffectAndCommand) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t, Results&) {});
  const History history = read(scratch);
  EXPECT_THAT(history.results, SizeIs(kCommits));
  EXPECT_THAT(history.lines, SizeIs(2 * 4));
  EXPECT_EQ(num_changes(history), 1U);
  const HistoryLine& line = line_of(history, "b", Measure::time);
  ASSERT_THAT(line.changes, SizeIs(1));
  EXPECT_EQ(line.changes[0].at, 8U);
  EXPECT_TRUE(line.changes[0].interval.contains(std::log(1.1)));
  const std::string text = summary(history);
  EXPECT_THAT(text, HasSubstr("between 000000abc007 and 000000abc008"));
  EXPECT_THAT(text, HasSubstr("time of grid on b n=16"));
  EXPECT_THAT(text, HasSubstr("ar3d compare " + scratch.path("000")));
  EXPECT_THAT(text, HasSubstr("time: 2 of 2 lines judged"));
}

TEST(History, UnlikeEnvironmentsAreNeverJoined) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t commit, Results& results) {
    if (commit >= 8) results.environment[0].value = "B";
  });
  const History history = read(scratch);
  EXPECT_THAT(history.environments, SizeIs(2));
  EXPECT_THAT(history.lines, SizeIs(2 * 2 * 4));
  EXPECT_EQ(num_changes(history), 0U);  // the machines differ, not the program
  for (const HistoryLine& line : history.lines) EXPECT_THAT(line.values, SizeIs(8));
}

TEST(History, OtherGraphsAreAnotherLine) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t commit, Results& results) {
    for (RunRecord& run : results.runs) {
      if (commit >= 4 && run.family == "b") run.graph_hash += "other";
    }
  });
  EXPECT_THAT(read(scratch).lines, SizeIs(3 * 4));
}

TEST(History, TimesOfABusyMachineOrADebugBuildAreLeftOutAndSaid) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t commit, Results& results) {
    if (commit == 3) results.environment[2].value = "1.90";
    if (commit == 4) results.runs[0].build_kind = "debug";
  });
  const History history = read(scratch);
  EXPECT_THAT(line_of(history, "a", Measure::time).values, SizeIs(kCommits - 2));
  EXPECT_THAT(line_of(history, "a", Measure::volume).values, SizeIs(kCommits));
  EXPECT_THAT(summary(history), HasSubstr("a busy machine (load 1.90)"));
  EXPECT_THAT(summary(history), HasSubstr("a debug build"));
}

TEST(History, TimesOfABusySpellAreCorrectedByTheYardstickAndSaid) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t commit, Results& results) {
    const double slowness = commit >= 11 ? 1.3 : 1;  // from then on the machine is slow
    if (commit >= 11) results.environment[2].value = "1.90";
    for (RunRecord& run : results.runs) {
      run.wall_s *= slowness;
      run.yardsticks_s = {slowness, slowness, slowness};
    }
  });
  const History history = read(scratch);
  EXPECT_THAT(line_of(history, "a", Measure::time).values, SizeIs(kCommits));
  EXPECT_EQ(num_changes(history), 1U) << "the program's, at commit 8";
  EXPECT_NEAR(history.results[12].slowness, 1.3, 1e-9);
  EXPECT_THAT(summary(history), HasSubstr("divided by 1.30"));
}

TEST(History, WhereAllResultsHaveCountsTheyAreJudgedAndTimesAreNot) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t commit, Results& results) {
    for (RunRecord& run : results.runs) {
      run.estimated_cycles = run.family == "a" && commit >= 5 ? 2100000 : 2000000;
    }
  });
  const History history = read(scratch);
  EXPECT_FALSE(line_of(history, "b", Measure::time).is_judged);
  EXPECT_EQ(num_changes(history), 1U);
  ASSERT_THAT(line_of(history, "a", Measure::cycles).changes, SizeIs(1));
  EXPECT_EQ(line_of(history, "a", Measure::cycles).changes[0].at, 5U);
  EXPECT_THAT(summary(history), HasSubstr("cycles of grid on a n=16"));
}

TEST(History, DrawingsAndInstructionsHaveNoNoise) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t commit, Results& results) {
    for (RunRecord& run : results.runs) {
      if (run.family != "a") continue;
      if (commit == 15) run.extents[0] += 1;  // of every graph, in the last commit
      if (commit >= 5) run.bends = {0, run.n, 0, run.n, 0, 0, 0, 0};
      if (commit >= 6) run.counted_instructions = 1020000;  // 2 %
      if (commit >= 9) run.counted_instructions = 1025000;  // 0.5 % more
    }
  });
  const History history = read(scratch);
  ASSERT_THAT(line_of(history, "a", Measure::volume).changes, SizeIs(1));
  EXPECT_EQ(line_of(history, "a", Measure::volume).changes[0].at, 15U);
  ASSERT_THAT(line_of(history, "a", Measure::bends).changes, SizeIs(1));
  EXPECT_EQ(line_of(history, "a", Measure::bends).changes[0].at, 5U);
  ASSERT_THAT(line_of(history, "a", Measure::instructions).changes, SizeIs(1));
  EXPECT_NEAR(line_of(history, "a", Measure::instructions).changes[0].effect, std::log(1.02),
              1e-12);
  EXPECT_THAT(line_of(history, "b", Measure::volume).changes, SizeIs(0));
}

TEST(History, AnUnfinishedRowLeavesAGapAndNoOtherValue) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t commit, Results& results) {
    if (commit == 2) results.runs[0].status = RunStatus::timeout;
  });
  const History history = read(scratch);
  EXPECT_THAT(line_of(history, "a", Measure::volume).values, SizeIs(kCommits - 1));
  EXPECT_EQ(history.results[2].unfinished, 1U);
}

TEST(History, ShortLinesAreNotJudgedAndSaid) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t commit, Results& results) {
    if (commit >= 6) results.runs.clear();
  });
  const History history = read(scratch);
  EXPECT_EQ(history.count(Measure::time, true), 0U);
  EXPECT_EQ(history.count(Measure::volume, true), 2U);
  EXPECT_THAT(summary(history), HasSubstr("time: 0 of 2 lines judged"));
  const auto about = tables_in(render_history(history, "h"))["summary"][0];
  EXPECT_EQ(about["unjudged"], 2);
  EXPECT_EQ(about["shortest"], 8);
}

TEST(History, ThePageIsOfflineEscapedAndShowsEveryCell) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t, Results& results) {
    results.environment[0].value = "<script>alert(1)</script>";
    for (RunRecord& run : results.runs) {
      if (run.family == "a") run.family = "<b>'\"&";
    }
  });
  const std::string page = render_history(read(scratch), "<i>");
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, Not(HasSubstr("<b>'")));
  EXPECT_THAT(page, Not(HasSubstr(" src=")));
  EXPECT_THAT(page, Not(HasSubstr("href='http")));
  EXPECT_THAT(page, Not(HasSubstr("https://")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  const auto tables = tables_in(page);
  EXPECT_EQ(tables["lines"].size(), 2U * 4U);
  EXPECT_EQ(tables["history"].size(), 2U * 4U * kCommits);
  EXPECT_EQ(tables["changes"].size(), 1U);
  EXPECT_EQ(tables["changes"][0]["direction"], "slower");
}

TEST(History, TheJsonHoldsLinesAndChanges) {
  const ScratchDirectory scratch;
  write_history(scratch, [](std::size_t, Results&) {});
  const auto json = nlohmann::json::parse(history_json(read(scratch)));
  EXPECT_EQ(json.at("results").size(), kCommits);
  EXPECT_EQ(json.at("lines").size(), 8U);
  std::size_t changes = 0;
  for (const auto& line : json.at("lines")) {
    changes += line.at("changes").size();
    EXPECT_EQ(line.at("values").size(), kCommits);
  }
  EXPECT_EQ(changes, 1U);
}

TEST(History, FilesWithoutPlaceOrResultsAreNamed) {
  const ScratchDirectory scratch;
  EXPECT_THROW(read(scratch), InputError);  // no results
  for (const char* name : {"x.h5", "12.h5", "_a_b.h5", "-1_a_b.h5", "1_a b_c.h5", "1__c.h5",
                           "99999999999999999999_a_b.h5"}) {
    const std::string path = scratch.write(name, "");
    EXPECT_THAT(problem([&] { read(scratch); }), HasSubstr(name)) << name;
    fs::remove(path);
  }
  scratch.write("000001_a_b.h5", "no HDF5");
  EXPECT_THROW(read(scratch), InputError);
}

}  // namespace
}  // namespace ar3d::testing
