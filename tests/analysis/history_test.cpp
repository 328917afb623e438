// Histories: what becomes one line, what is left out, and what the page says.
#include "ar3d/analysis/history/history.h"

#include <fmt/format.h>

#include <cmath>

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

/// Two settings of two cells of three graphs, timed; "grid" is 30 % slower from commit 8 on.
Results commit_results(std::size_t commit) {
  Results results = good_results({"grid", "two-bend"}, {"a", "b"}, 1, 3);
  results.study_id = "tiny";
  results.source_hash = hash_of(commit);
  results.created = "2026-01-01T00:00:00Z";
  results.environment = {{"cpu", "A", 1}, {"cores", "2", 1}, {"load_before", "0.10", 1}};
  RandomStream random(7, commit);
  for (RunRecord& run : results.runs) {
    run.wall_s = 1e-3 * (1 + 0.002 * normal(random));
    if (run.algorithm == "grid" && commit >= 8) run.wall_s *= 1.3;
    run.counted_instructions = 1000000;
    run.session = 1;
  }
  return results;
}

History read(const ScratchDirectory& scratch) { return read_history(scratch.path(""), {}); }

/// The history of the commits, each changed by `change`.
template <class Change>
History history_of(Change change) {
  const ScratchDirectory scratch;
  for (std::size_t commit = 0; commit < kCommits; ++commit) {
    Results results = commit_results(commit);
    change(commit, results);
    const std::string name =
        history_file_name(static_cast<std::int64_t>(100 + commit), results.source_hash.substr(28),
                          results, results.environment);
    write_results(results, scratch.path(name));
  }
  return read(scratch);
}

/// Of `grid`.
const HistoryLine& line_of(const History& history, const std::string& family, Measure measure) {
  for (const HistoryLine& line : history.lines) {
    if (line.cell.curve.algorithm == "grid" && line.cell.curve.family == family &&
        line.measure == measure) {
      return line;
    }
  }
  throw InputError("no such line");
}

/// "15: grid volume 1 of 2": place among the results, what changed, and of how many cells.
std::vector<std::string> changes_of(const History& history) {
  std::vector<std::string> texts;
  for (const HistoryChange& change : history.changes) {
    texts.push_back(fmt::format("{}: {} {} {} of {}", change.at, change.setting,
                                direction_text(change), change.cells, change.of));
  }
  return texts;
}

constexpr const char* kSlower = "8: grid slower 2 of 2";

TEST(History, ASeededStepIsFoundWithItsCommitsEffectAndCommand) {
  const History history = history_of([](std::size_t, Results&) {});
  EXPECT_THAT(history.results, SizeIs(kCommits));
  EXPECT_THAT(history.lines, SizeIs(4 * 4));
  EXPECT_THAT(changes_of(history), ElementsAre(kSlower));
  EXPECT_TRUE(history.changes[0].interval.contains(std::log(1.3)));
  EXPECT_EQ(history.changes[0].before, 7U);
  EXPECT_THAT(history.sights, SizeIs(2));
  const std::string text = summary(history);
  EXPECT_THAT(text, HasSubstr("000000abc008, after 000000abc007\n    ar3d compare " +
                              fs::path(history.results[0].file).parent_path().string() + "/000"));
  EXPECT_THAT(text, HasSubstr("    grid: slower +"));
  EXPECT_THAT(text, HasSubstr("time: 4 of 4 lines judged"));
  EXPECT_THAT(text, HasSubstr("the smallest change that these results show: +"));
}

TEST(History, UnlikeEnvironmentsAreNeverJoined) {
  const History history = history_of([](std::size_t commit, Results& results) {
    if (commit >= 8) results.environment[0].value = "B";
  });
  EXPECT_THAT(history.environments, SizeIs(2));
  EXPECT_THAT(history.lines, SizeIs(2 * 4 * 4));
  EXPECT_THAT(history.changes, IsEmpty());  // the machines differ, not the program
  for (const HistoryLine& line : history.lines) EXPECT_THAT(line.values, SizeIs(8));
}

TEST(History, OtherGraphsAreAnotherLine) {
  const History history = history_of([](std::size_t commit, Results& results) {
    for (RunRecord& run : results.runs) {
      if (commit >= 4 && run.family == "b") run.graph_hash += "other";
    }
  });
  EXPECT_THAT(history.lines, SizeIs(6 * 4));
}

TEST(History, TimesOfABusyMachineOrADebugBuildAreLeftOutAndSaid) {
  const History history = history_of([](std::size_t commit, Results& results) {
    if (commit == 3) results.environment[2].value = "1.90";
    if (commit == 4) results.runs[0].build_kind = "debug";
  });
  EXPECT_THAT(line_of(history, "a", Measure::time).values, SizeIs(kCommits - 2));
  EXPECT_THAT(line_of(history, "a", Measure::volume).values, SizeIs(kCommits));
  EXPECT_THAT(summary(history), HasSubstr("a busy machine (load 1.90)"));
  EXPECT_THAT(summary(history), HasSubstr("a debug build"));
}

TEST(History, TimesOfABusySpellAreCorrectedByTheYardstickAndSaid) {
  const History history = history_of([](std::size_t commit, Results& results) {
    const double slowness = commit >= 11 ? 1.3 : 1;  // from then on the machine is slow
    if (commit >= 11) results.environment[2].value = "1.90";
    for (RunRecord& run : results.runs) {
      run.wall_s *= slowness;
      run.yardsticks_s = {slowness, slowness, slowness};
    }
  });
  EXPECT_THAT(line_of(history, "a", Measure::time).values, SizeIs(kCommits));
  EXPECT_THAT(changes_of(history), ElementsAre(kSlower));
  EXPECT_NEAR(history.results[12].slowness, 1.3, 1e-9);
  EXPECT_THAT(summary(history), HasSubstr("divided by 1.30"));
}

TEST(History, WhereAllResultsHaveCountsTheyAreJudgedAndTimesAreNot) {
  const History history = history_of([](std::size_t commit, Results& results) {
    for (RunRecord& run : results.runs) {
      run.estimated_cycles = run.family == "a" && commit >= 5 ? 2100000 : 2000000;
    }
  });
  EXPECT_FALSE(line_of(history, "b", Measure::time).is_judged);
  EXPECT_THAT(changes_of(history),
              ElementsAre("5: grid more cycles 1 of 2", "5: two-bend more cycles 1 of 2"));
  EXPECT_THAT(summary(history), HasSubstr("grid on a n=16: more cycles +5 %, 1 of 2 cells"));
}

TEST(History, DrawingsAndInstructionsHaveNoNoise) {
  const History history = history_of([](std::size_t commit, Results& results) {
    for (RunRecord& run : results.runs) {
      if (run.algorithm != "grid") continue;
      if (commit == 15) run.log2_volume += ++run.extents[0] > 0;  // in the last commit
      if (run.family != "a") continue;
      if (commit >= 5) run.bends = {0, run.n, 0, run.n, 0, 0, 0, 0};
      if (commit >= 6) run.counted_instructions = 1008000;  // 0.8 %
      if (commit >= 9) run.counted_instructions = 1016000;  // as much again
    }
  });
  EXPECT_THAT(changes_of(history),
              ElementsAre("15: grid larger volume 2 of 2", "9: grid more instructions 1 of 2",
                          kSlower, "5: grid fewer bends 1 of 2"));
  EXPECT_NEAR(history.changes[1].effect, std::log(1.016), 1e-12);
}

TEST(History, AnUnfinishedRowLeavesAGapAndNoOtherValue) {
  const History history = history_of([](std::size_t commit, Results& results) {
    if (commit == 2) results.runs[0].status = RunStatus::timeout;
  });
  EXPECT_THAT(line_of(history, "a", Measure::volume).values, SizeIs(kCommits - 1));
  EXPECT_EQ(history.results[2].unfinished, 1U);
}

TEST(History, ShortLinesAreNotJudgedAndSaid) {
  const History history = history_of([](std::size_t commit, Results& results) {
    if (commit >= 6) results.runs.clear();
  });
  EXPECT_THAT(summary(history), HasSubstr("time: 0 of 4 lines judged"));
  EXPECT_THAT(summary(history), HasSubstr("volume: 4 of 4 lines judged"));
  EXPECT_THAT(summary(history), HasSubstr("too few results to show a change"));
}

TEST(History, ThePageIsOfflineEscapedAndShowsEveryCell) {
  const History history = history_of([](std::size_t, Results& results) {
    results.environment[0].value = "<script>alert(1)</script>";
    for (RunRecord& run : results.runs) {
      if (run.family == "a") run.family = "<b>'\"&";
    }
  });
  const std::string page = render_page("history", "<i>", history_tables(history, "<i>"));
  for (const char* no : {"<script>alert", "<b>'", " src=", "href='http", "https://"}) {
    EXPECT_THAT(page, Not(HasSubstr(no)));
  }
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  const auto tables = tables_in(page);
  EXPECT_EQ(tables["lines"].size(), 4U * 4U);
  EXPECT_EQ(tables["history"].size(), 4U * 4U * kCommits);
  EXPECT_EQ(tables["sights"].size(), 2U);
  EXPECT_EQ(tables["changes"].size(), 1U);
  EXPECT_EQ(tables["changes"][0]["direction"], "slower");
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
