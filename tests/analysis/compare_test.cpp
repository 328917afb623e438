// Two results, one verdict: what has no noise first, then times.
#include "ar3d/analysis/compare/compare.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ar3d/base/error.h"
#include "synthetic.h"

namespace ar3d::testing {
namespace {

using Row = RunRecord;  // within a test, RunRecord is gtest's

/// "REGRESSED 3: 200 PASS, 100 REGRESSED": word, exit code, and how many cells are what.
std::string told(const Comparison& comparison) {
  std::string text = fmt::format("{} {}", comparison.word(), comparison.exit_code());
  const char* separator = ": ";
  for (const Verdict verdict : {Verdict::pass, Verdict::improved, Verdict::unjudged,
                                Verdict::inconclusive, Verdict::regressed, Verdict::violated}) {
    const std::size_t count = comparison.count(verdict);
    if (count == 0) continue;
    text += fmt::format("{}{} {}", std::exchange(separator, ", "), count, to_string(verdict));
  }
  return text;
}

constexpr const char* kAllPass = "PASS 0: 300 PASS";

TEST(Compare, AResultAgainstAnotherRunOfTheSameProgramPasses) {
  EXPECT_EQ(told(compare(results_of(15, 1), results_of(15, 2))), kAllPass);
}

TEST(Compare, ASeededVolumeRegressionIsFoundWhereverItIs) {
  const Results base = results_of(1, 1);
  for (std::size_t row = 0; row < base.runs.size(); ++row) {
    Results now = results_of(1, 2);
    now.runs[row].extents[row % 3] += 1;
    ASSERT_EQ(told(compare(base, now)), "REGRESSED 3: 299 INCONCLUSIVE, 1 REGRESSED") << row;
  }
}

/// All rows those of programs without a guarantee.
Results measured(Results results) {
  for (Row& run : results.runs) {
    run.status = RunStatus::measured;
    run.violations = -1;
  }
  return results;
}

TEST(Compare, TimesOfMeasuredRowsAreJudged) {
  const Results base = measured(results_of(15, 1));
  Results now = measured(results_of(15, 2));
  EXPECT_EQ(told(compare(base, now)), kAllPass);
  for (Row& run : now.runs) {
    if (run.algorithm == "grid") run.wall_s *= 1.1;
  }
  EXPECT_EQ(told(compare(base, now)), "REGRESSED 3: 200 PASS, 100 REGRESSED");
}

TEST(Compare, AMeasuredRowThatIsNoLongerDrawnIsARegression) {
  const Results base = measured(results_of(1, 1));
  Results now = base;
  now.runs[7].status = RunStatus::crashed;
  EXPECT_EQ(compare(base, now).count(Verdict::regressed), 1u);
  EXPECT_EQ(compare(now, base).count(Verdict::improved), 1u);
}

TEST(Compare, AFileUnderAnotherNameHasTheSameRows) {
  Results base = results_of(1, 1), now = results_of(1, 2);
  for (std::size_t row = 0; row < base.runs.size(); ++row) {
    base.runs[row].row_key = now.runs[row].row_key = "key" + std::to_string(row);
    if (now.runs[row].family == "family3") now.runs[row].family = "renamed.s6";
  }
  const Comparison comparison = compare(base, now);
  EXPECT_TRUE(comparison.incomplete.empty()) << comparison.incomplete.front();
  EXPECT_EQ(comparison.rows, base.runs.size());
  now.runs[35].graph_hash = "other";  // of family3, under the same key
  EXPECT_EQ(compare(base, now).exit_code(), 5);
}

TEST(Compare, VolumesAreComparedExactlyBeyondSixtyFourBits) {
  Results base = results_of(1, 1), now = results_of(1, 1);
  base.runs[0].extents =
      now.runs[0].extents = {3'000'000'000, 3'000'000'000, 9'000'000'000'000'000};
  now.runs[0].extents[2] += 1;
  EXPECT_EQ(compare(base, now).count(Verdict::regressed), 1u);
  EXPECT_EQ(compare(now, base).count(Verdict::improved), 1u);
}

TEST(Compare, EveryNoiselessChangeHasItsVerdict) {
  const Results base = results_of(1, 1);
  const auto verdict_with = [&](auto change) {
    Results now = base;
    change(now.runs[7]);
    const Comparison comparison = compare(base, now);
    for (const CellComparison& cell : comparison.cells) {
      if (cell.verdict != Verdict::pass && cell.verdict != Verdict::inconclusive) {
        return cell.verdict;
      }
    }
    return Verdict::pass;
  };
  EXPECT_EQ(verdict_with([](Row&) {}), Verdict::pass);
  EXPECT_EQ(verdict_with([](Row& r) { r.status = RunStatus::crashed; }), Verdict::regressed);
  EXPECT_EQ(verdict_with([](Row& r) { r.status = RunStatus::violated; }), Verdict::violated);
  EXPECT_EQ(verdict_with([](Row& r) { r.violations = 2; }), Verdict::violated);
  EXPECT_EQ(verdict_with([](Row& r) { r.violations = -1; }), Verdict::regressed);
  EXPECT_EQ(verdict_with([](Row& r) { r.certificate = "sample=10"; }), Verdict::regressed);
  EXPECT_EQ(verdict_with([](Row& r) { r.graph_hash = "other"; }), Verdict::regressed);
  EXPECT_EQ(verdict_with([](Row& r) { r.extents[0] -= 1; }), Verdict::improved);
  EXPECT_EQ(verdict_with([](Row& r) { std::swap(r.extents[1], r.extents[2]); }), Verdict::pass);
  EXPECT_EQ(verdict_with([](Row& r) { r.bends[2] -= 1, r.bends[3] += 1; }), Verdict::regressed);
  EXPECT_EQ(verdict_with([](Row& r) { r.bends[3] -= 1, r.bends[2] += 1; }), Verdict::improved);
  EXPECT_EQ(verdict_with([](Row& r) { r.bends[0] += 1, r.bends[4] += 1; }), Verdict::regressed);
}

TEST(Compare, CountedInstructionsAreAGateOfTheirOwn) {
  Results base = results_of(1, 1), now = results_of(1, 1);
  for (Row& run : base.runs) run.counted_instructions = 1'000'000;
  for (Row& run : now.runs) run.counted_instructions = 1'005'000;  // within 1 %
  EXPECT_EQ(compare(base, now).count(Verdict::regressed), 0u);
  for (std::size_t i = 0; i < 10; ++i) now.runs[i].counted_instructions = 1'020'000;
  const Comparison comparison = compare(base, now);
  EXPECT_EQ(told(comparison), "REGRESSED 3: 290 PASS, 10 REGRESSED")
      << "one round of times, but counts decide";
  EXPECT_THAT(comparison.judged(), HasSubstr("300 of 300 cells"));
  for (Row& run : base.runs) run.estimated_cycles = 1'500'000;
  for (Row& run : now.runs) run.estimated_cycles = 1'600'000;  // more misses of the cache
  EXPECT_EQ(compare(base, now).count(Verdict::regressed), 300u);
}

TEST(Compare, CountsDecideWhateverTheMachine) {
  Results base = results_of(15, 1), now = results_of(15, 2);
  for (Results* side : {&base, &now}) {
    for (Row& run : side->runs) run.counted_instructions = run.n * 1000;
  }
  now.environment[0].value = "B";
  EXPECT_EQ(compare(base, now).word(), "PASS") << "on another machine";
  now.environment[0].value = "A";
  for (Row& run : now.runs) {
    if (run.algorithm == "grid") run.wall_s *= 1.1;
  }
  EXPECT_EQ(told(compare(base, now)), "INCONCLUSIVE 6: 200 PASS, 100 INCONCLUSIVE")
      << "slower at equal counts";
}

/// All rows beside yardsticks that take so many times as long as usual.
Results with_yardsticks(Results results, std::array<double, 3> slowness) {
  RandomStream random(3);
  for (Row& run : results.runs) {
    for (std::size_t i = 0; i < slowness.size(); ++i) {
      run.yardsticks_s[i] = slowness[i] * 1e-3 * std::exp(std::abs(0.005 * normal(random)));
    }
  }
  return results;
}

/// Nothing changed but `grid`, slower by 20 %, and a machine slower by 27 %.
Comparison on_slow_machine(std::array<double, 3> yardsticks) {
  Results now = results_of(15, 2);
  for (Row& run : now.runs) run.wall_s *= run.algorithm == "grid" ? 1.27 * 1.2 : 1.27;
  return compare(with_yardsticks(results_of(15, 1), {1, 1, 1}), with_yardsticks(now, yardsticks));
}

TEST(Compare, ASlowClockIsAccountedFor) {
  const Comparison comparison = on_slow_machine({1.27, 1.27, 1.27});
  EXPECT_EQ(told(comparison), "REGRESSED 3: 200 PASS, 100 REGRESSED");
  EXPECT_THAT(comparison.judged(), HasSubstr("which yardsticks account for: its times are (NEW "
                                             "over BASE) cached 1.27, memory 1.27, arithmetic "
                                             "1.27 for the yardsticks and, in units of theirs, "
                                             "1.00 for all settings together"));
}

TEST(Compare, AnUnknownStateOfTheMachineIsToldAndNothingPassesOrRegresses) {
  const Comparison comparison = on_slow_machine({1.27, 1.27, 1});  // neighbours in the caches
  EXPECT_EQ(told(comparison), "INCONCLUSIVE 6: 300 INCONCLUSIVE");
  EXPECT_THAT(comparison.judged(), AllOf(HasSubstr("in units of theirs, 1.13 for all settings"),
                                         Not(HasSubstr("To know more"))));
  Comparison with_remedy = comparison;
  with_remedy.remedy = "To know more: `ar3d compare --turns A B` takes turns";
  EXPECT_THAT(with_remedy.judged(), EndsWith(". " + with_remedy.remedy));
}

TEST(Compare, ASlowerCellIsFoundAndNothingElse) {
  Results now = results_of(15, 2);
  for (Row& run : now.runs) {
    if (run.algorithm == "grid" && run.family == "family4" && run.n == 1024) run.wall_s *= 1.4;
  }
  const Comparison comparison = compare(results_of(15, 1), now);
  EXPECT_EQ(told(comparison), "REGRESSED 3: 299 PASS, 1 REGRESSED");
  EXPECT_THAT(summary(comparison, {}), HasSubstr("grid on family4 n=1024"));
  EXPECT_THAT(comparison.judged(), HasSubstr("how fast the machine was is not known: times are "
                                             "(NEW over BASE) 1.00 for all"));
}

TEST(Compare, TheTimingPhaseIsWhatCounts) {
  const Results base = timed(results_of(15, 1));
  Results now = timed(results_of(15, 2));
  for (Row& run : now.runs) {
    if (run.phase == RunPhase::metrics) run.wall_s *= 3;  // disturbed by its neighbours
  }
  EXPECT_EQ(told(compare(base, now)), kAllPass);
  now.runs.pop_back();  // a study may repeat until it is precise enough
  EXPECT_EQ(compare(base, now).exit_code(), 0);
}

TEST(Compare, UnlikeEnvironmentsAreFlaggedAndTimesAreNoGateUnlessAsked) {
  Results base = results_of(15, 1), now = results_of(15, 2);
  for (Row& run : now.runs) run.wall_s *= 2;
  now.environment[2].value = "-O0";
  const Comparison comparison = compare(base, now);
  EXPECT_EQ(told(comparison), "UNJUDGED 7: 300 UNJUDGED");
  EXPECT_THAT(summary(comparison, {}),
              AllOf(HasSubstr("largest other changes of time (NOT JUDGED)"), HasSubstr("15 rounds"),
                    HasSubstr("flags: -O3 -> -O0")));
  EXPECT_EQ(compare(base, now, {.time_always = true}).exit_code(), 6);

  now.environment[2].value = "-O3";
  now.environment.push_back({"load_before", "1.50 1.00 1.00", 0});
  EXPECT_THAT(summary(compare(base, now), {}), HasSubstr("judged: drawings only")) << "a busy one";
  now.environment.back().value = "0.20 1.00 1.00";
  EXPECT_TRUE(compare(base, now).time_judged);
  now.runs[0].build_kind = "sanitised";
  EXPECT_FALSE(compare(base, now).time_judged);
}

/// The whole program slower by so many per cent; of loaded machines tests/apps/slowdowns_test.cpp.
TEST(Compare, ASlowerProgramNeverPasses) {
  const Results base = results_of(15, 1);
  for (const double percent : {3.0, 5.0, 10.0, 20.0, 50.0}) {
    Results now = results_of(15, 2);
    for (Row& run : now.runs) run.wall_s *= 1 + percent / 100;
    const Comparison quiet = compare(base, now);
    EXPECT_EQ(quiet.word(), "INCONCLUSIVE") << percent << ": the program or the machine";
    EXPECT_THAT(summary(quiet, {}), HasSubstr("judged: drawings and times")) << percent;
  }
}

TEST(Compare, FewPairsOrMuchNoiseAreInconclusiveAndNoPass) {
  Results base = results_of(1, 1), now = results_of(1, 2);
  for (Results* side : {&base, &now}) {
    std::erase_if(side->runs, [](const Row& run) { return run.n > 64; });
  }
  const Comparison few = compare(base, now);
  EXPECT_THAT(told(few), StartsWith("INCONCLUSIVE 6: "));
  EXPECT_THAT(summary(few, {}), HasSubstr("1 rounds of times; 4 are needed"));
  now = results_of(15, 2);
  now.runs[0].extents[0] -= 1;  // better, but the noise of the times hides everything
  for (std::size_t i = 0; i < now.runs.size(); ++i) now.runs[i].wall_s *= i % 2 == 0 ? 0.7 : 1.4;
  EXPECT_EQ(compare(results_of(15, 1), now).word(), "INCONCLUSIVE");
}

TEST(Compare, AFileAgainstItselfPassesWhateverTheMachineWasDoing) {
  Results base = results_of(1, 1);  // too few pairs for any test
  base.environment.push_back({"load_before", "7.00 7.00 7.00", 0});
  base.runs[0].build_kind = "sanitised";
  base.runs[5].status = RunStatus::refused;
  EXPECT_EQ(told(compare(base, base)), kAllPass);
  Results other = base;
  other.runs[3].wall_s *= 1 + 1e-9;  // another measurement after all
  EXPECT_EQ(compare(base, other).word(), "UNJUDGED");
}

TEST(Compare, DrawingsAloneAreJudgedIfThatIsAsked) {
  Results now = results_of(15, 2);
  for (Row& run : now.runs) run.wall_s *= 2;
  const CompareOptions drawings{.drawings_only = true};
  const Comparison comparison = compare(results_of(15, 1), now, drawings);
  EXPECT_EQ(told(comparison), "DRAWINGS PASS 0: 300 PASS");
  for (const std::string& text :
       {summary(comparison, drawings), comparison_markdown(comparison, drawings)}) {
    for (const char* of_times : {"of time", "UNLIKE", "pairs, p "}) {
      EXPECT_THAT(text, Not(HasSubstr(of_times))) << "where no times were asked for";
    }
  }
  now.runs[0].extents[0] += 1;
  EXPECT_EQ(compare(results_of(15, 1), now, drawings).exit_code(), 3);
}

TEST(Compare, TheLargestChangesAreShownWhateverTheVerdict) {
  Results now = results_of(15, 2);
  for (Row& run : now.runs) {
    if (run.algorithm == "grid" && run.family == "family4" && run.n == 1024) {
      run.wall_s *= 1.03;
    }
  }
  const std::string text = summary(compare(results_of(15, 1), now), {});
  const std::size_t times = text.find("largest other changes of time (judged)\n");
  ASSERT_NE(times, std::string::npos) << text;
  EXPECT_NE(text.find("grid on family4 n=1024", times), std::string::npos) << text;
}

TEST(Compare, NoMachineIsAsFastBesideAFasterMemory) {
  const Results base = with_yardsticks(results_of(15, 1), {1, 1, 1});
  const auto said = [&](double memory) {
    return compare(base, with_yardsticks(results_of(15, 2), {1, memory, 1})).judged();
  };
  EXPECT_THAT(said(1.02), HasSubstr("The machine was as fast in both"));
  EXPECT_THAT(said(0.54),
              AllOf(HasSubstr("its memory not"), Not(HasSubstr("machine was as fast"))));
}

TEST(Compare, RoundsArePairsOfTheirSmallestTimes) {
  std::vector<Results> base, now;
  for (std::uint64_t round = 0; round < 20; ++round) {
    base.push_back(results_of(3, 100 + round));
    now.push_back(results_of(3, 200 + round));
    for (Row& run : now.back().runs) {
      if (run.algorithm == "diamond" && run.family == "family0" && run.n == 16) run.wall_s *= 1.1;
      if (run.repetition == 1) run.wall_s *= 5;  // bursts
    }
  }
  const Comparison comparison = compare_rounds(base, now);
  EXPECT_EQ(told(comparison), "REGRESSED 3: 299 PASS, 1 REGRESSED");
  EXPECT_EQ(comparison.cells.front().time.pairs, 20u);
  EXPECT_EQ(comparison.cells.front().verdict, Verdict::regressed);
  now[9].runs[50].extents[0] += 1;  // in one round only: the program is not deterministic any more
  EXPECT_EQ(compare_rounds(base, now).count(Verdict::regressed), 2u);
}

TEST(Compare, WhatIsMissingIsIncompleteAndNeverAPass) {
  const Results base = results_of(15, 1);
  Results now = results_of(15, 2);
  now.runs.pop_back();
  Comparison comparison = compare(base, now);
  EXPECT_EQ(comparison.exit_code(), 5);
  EXPECT_THAT(comparison.incomplete.at(0), HasSubstr("repetition 14"));

  Results empty = base;
  empty.runs.clear();
  comparison = compare(empty, empty);
  EXPECT_EQ(comparison.exit_code(), 5);
  EXPECT_THAT(comparison.incomplete.at(0), HasSubstr("nothing measured: BASE has no rows"));
  EXPECT_EQ(compare(empty, base).exit_code(), 5);

  now = results_of(15, 2);
  now.planned_rows = static_cast<std::int64_t>(now.runs.size()) + 1;
  EXPECT_EQ(compare(base, now).exit_code(), 5);
}

TEST(Compare, ATimeThatIsNoNumberIsToldAndLeftOut) {
  for (const double bad : {kMissing, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    Results now = results_of(15, 2);
    now.runs[3].wall_s = bad;
    const Comparison comparison = compare(results_of(15, 1), now);
    EXPECT_EQ(comparison.exit_code(), 5) << bad;
    EXPECT_THAT(comparison.incomplete.at(0), HasSubstr("1 drawn measurements have no time"));
    EXPECT_EQ(comparison.cells.front().time.pairs, 14u);
  }
}

TEST(Compare, MixedStudiesAndDoubleRowsAreRefused) {
  const Results base = results_of(1, 1);
  Results other = base;
  other.study_id = "another";
  EXPECT_THROW(compare(base, other), InputError);
  Results twice = base;
  twice.runs.push_back(twice.runs.front());
  EXPECT_THROW(compare(base, twice), InputError);
  EXPECT_THROW(compare(twice, base), InputError);
}

TEST(Compare, JsonHoldsTheVerdictAndNullForWhatIsMissing) {
  Results now = results_of(1, 2);
  now.runs[0].extents[0] += 5;
  const auto json = nlohmann::json::parse(comparison_json(compare(results_of(1, 1), now), {}));
  EXPECT_EQ(json.at("verdict"), "REGRESSED");
  EXPECT_EQ(json.at("exit_code"), 3);
  EXPECT_EQ(json.at("cells").size(), 300u);
  EXPECT_EQ(json.at("settings").size(), 3u);
  EXPECT_EQ(json.at("cells")[0].at("verdict"), "REGRESSED");
  EXPECT_TRUE(json.at("cells")[0].at("instructions_ratio").is_null());
  EXPECT_TRUE(json.at("cells")[0].at("time").at("ratio").is_number());
}

}  // namespace
}  // namespace ar3d::testing
