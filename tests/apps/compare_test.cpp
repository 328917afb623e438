// `ar3d compare` as its users run it: files, two builds in turns.
#include <nlohmann/json.hpp>

#include "apps/checkouts.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

constexpr const char* kStudy =
    "study = 'tiny'\n[[sweep]]\nfamilies = ['cycle', 'random-cubic']\nsizes = [20, 50]\n"
    "algorithms = 'all'\nrepetitions = 3\n";

/// A small study's results in the scratch directory.
std::string tiny_results(const ScratchDirectory& scratch, const std::string& name) {
  const std::string spec = scratch.write("tiny.toml", kStudy), path = scratch.path(name);
  expect_exit(0, run("{} study run " + spec + " --threads 1 --quiet -o " + path));
  return path;
}

template <class Change>
std::string changed(const std::string& path, const std::string& name, Change change) {
  Results results = read_results(path);
  change(results);
  const std::string result = fs::path(path).replace_filename(name);
  write_results(results, result);
  return result;
}

TEST(CompareProgram, TheYoungestReferenceOfTheStudyIsTheBase) {
  const ScratchDirectory scratch;
  const std::string now = tiny_results(scratch, "now.h5");
  const std::string checkout = scratch.path("checkout");
  fs::create_directories(checkout + "/apps");
  fs::create_directories(checkout + "/results/reference");
  must("touch " + checkout + "/apps/study.cpp && git init -q " + checkout);
  const std::string compare = "cd " + checkout + " && {} compare --reference " + now;
  expect_exit(2, run(compare));  // no reference yet
  const std::string smaller =
      changed(now, "smaller.h5", [](Results& r) { r.runs[4].extents[1] -= 1; });
  fs::copy_file(now, checkout + "/results/reference/0.1.0-tiny.h5");
  expect_exit(0, run(compare));
  fs::copy_file(smaller, checkout + "/results/reference/0.2.0-tiny.h5");
  expect_exit(3, run(compare));
}

// What git says goes through no file: who knows the process's number can name one before.
TEST(CompareProgram, GitAnswersIntoNoFile) {
  const ScratchDirectory scratch;
  const std::string victim = scratch.write("victim", "mine\n");
  tiny_results(scratch, "r.h5");
  const Outcome asked = run("cd " + scratch.path("") + " && ln -s " + victim +
                            " ar3d-git-$$ && export TMPDIR=" + scratch.path("") +
                            " && exec {} compare --reference r.h5");
  expect_one_line(asked, "in no git checkout");
  EXPECT_EQ(read_file(victim), "mine\n");
  expect_exit(0, run("ls " + scratch.path("ar3d-git-*")));
}

TEST(CompareProgram, TheCommittedReferenceIsWholeAndProved) {
  const std::string reference = std::string(AR3D_SOURCE_DIR) + "/results/reference/0.2.0-volume.h5";
  expect_output(run("{} check " + reference), "21528 rows, 21528 proved");
  expect_exit(0, run("{} compare " + reference + " " + reference));
}

TEST(CompareProgram, AFileAgainstItselfPassesAndAGrownBoxIsARegression) {
  const ScratchDirectory scratch;
  const std::string base = tiny_results(scratch, "base.h5");
  expect_exit(0, run("{} compare " + base + " " + base));

  const std::string grown =
      changed(base, "grown.h5", [](Results& r) { r.runs[4].extents[1] += 1; });
  const std::string verdict = scratch.path("verdict.json");
  expect_output(run("{} compare " + base + " " + grown + " --json " + verdict), "larger volume", 3);
  EXPECT_EQ(nlohmann::json::parse(read_file(verdict)).at("verdict"), "REGRESSED");

  const std::string broken =
      changed(base, "broken.h5", [](Results& r) { r.runs[4].status = RunStatus::violated; });
  expect_exit(4, run("{} compare " + base + " " + broken));
}

TEST(CompareProgram, AFileSaysWhyItHasNoMoreRounds) {
  const ScratchDirectory scratch;
  const std::string spec =
      scratch.write("timed.toml", std::string(kStudy) + "timed_repetitions = 4\n");
  const std::string path = scratch.path("timed.h5");
  must("{} study run " + spec + " --threads 1 --force-timing -q -o " + path);
  const std::string said = "made 4 rounds, as many as the study makes: ";
  expect_output(run("{} compare " + path + " " + path), {"BASE " + said, "NEW " + said});
  EXPECT_THAT(read_file(scratch.path("timed.html")), HasSubstr("\"timing_rounds\""));
}

TEST(CompareProgram, TheVerdictIsWrittenAsMarkdown) {
  const ScratchDirectory scratch;
  const std::string base = tiny_results(scratch, "base.h5");
  const std::string grown = changed(base, "grown.h5", [](Results& r) {
    r.runs[4].extents[1] += 1;
    for (RunRecord& run : r.runs) {
      if (run.family == "cycle") run.family = "a|b`c # d";
    }
  });
  const std::string named = changed(base, "named.h5", [](Results& r) {
    for (RunRecord& run : r.runs) {
      if (run.family == "cycle") run.family = "a|b`c # d";
    }
  });
  const std::string file = scratch.path("verdict.md");
  const std::string compare = "{} compare " + named + " " + grown + " --markdown ";
  expect_exit(3, run(compare + file));
  const Outcome piped = expect_exit(3, run(compare + "-"));
  EXPECT_EQ(piped.out, read_file(file));
  EXPECT_THAT(piped.out, StartsWith("## ar3d compare: REGRESSED\n"));
  EXPECT_THAT(piped.out, HasSubstr("| verdict | cell | counts, time | volume | reason |"));
  EXPECT_THAT(piped.out, HasSubstr("`larger volume"));
  EXPECT_THAT(piped.out, HasSubstr("on a\\|b'c # d n="));  // one field of one line
  expect_error(run(compare + file), "--force replaces it");
  expect_exit(2, run(compare + scratch.path("nowhere/verdict.md")));
}

TEST(CompareProgram, BadInputIsOneClearLine) {
  const ScratchDirectory scratch;
  const std::string pipe = scratch.path("pipe");
  must("mkfifo " + pipe);
  const std::string base = tiny_results(scratch, "base.h5");
  const std::string other = changed(base, "other.h5", [](Results& r) { r.study_id = "another"; });
  const std::string twice =
      changed(base, "twice.h5", [](Results& r) { r.runs.push_back(r.runs.back()); });
  const std::string garbage = scratch.write("garbage.json", "{\"benchmarks\": [{]}");
  for (const auto& [arguments, message] : std::vector<std::pair<std::string, std::string>>{
           {base + " " + other, "different studies: BASE is 'tiny', NEW is 'another'"},
           {base + " " + twice, "NEW holds the same measurement twice"},
           {base + " " + garbage, "garbage.json"},
           {base + " " + base + ".missing", "missing"},
           {base + " " + pipe, "pipe is not an HDF5 file"},
           {base, "compare takes two results files"},
           {"--base no-such-ref-anywhere", "no commit 'no-such-ref-anywhere'"},
           {"--base HEAD " + base, "--base takes no results files"}}) {
    expect_one_line(run("cd " AR3D_SOURCE_DIR " && {} compare " + arguments), message);
  }
}

TEST(CompareProgram, OtherVersionsAndMissingTablesAreNamed) {
  const ScratchDirectory scratch;
  const std::string base = tiny_results(scratch, "base.h5");
  for (const auto& [edit, message] : std::vector<std::pair<std::string, std::string>>{
           {"f.attrs[\"format_version\"] = 1", "version"}, {"del f[\"runs\"]", "runs"}}) {
    const std::string broken = scratch.path("broken.h5");
    fs::copy_file(base, broken, fs::copy_options::overwrite_existing);
    must("/usr/bin/python3 -c 'import h5py; f = h5py.File(\"" + broken + "\", \"r+\"); " + edit +
         "'");
    renew_checksum(broken);
    const Outcome outcome = run("{} compare " + base + " " + broken);
    expect_one_line(outcome, message);
    EXPECT_THAT(outcome.err, HasSubstr("broken.h5"));
  }
}

TEST(CompareProgram, NothingMeasuredAndNaNAreIncomplete) {
  const ScratchDirectory scratch;
  const std::string base = tiny_results(scratch, "base.h5");
  const std::string empty = changed(base, "empty.h5", [](Results& r) { r.runs.clear(); });
  expect_output(run("{} compare " + empty + " " + empty), "nothing measured", 5);
  const std::string nan =
      changed(base, "nan.h5", [](Results& r) { r.runs[0].wall_s = r.runs[0].cpu_s = kMissing; });
  expect_output(run("{} compare " + base + " " + nan), "1 drawn measurements have no time", 5);
}

TEST(CompareProgram, ACommitIsBuiltOnceAndItsWorktreeGoes) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("tiny.toml", kStudy);
  const std::string checkout = pretended_checkout(scratch, "true");
  const std::string command = "cd " + checkout +
                              " && AR3D_PROGRAM=$(realpath {}) {} compare --base HEAD --rounds 1 "
                              "--study " +
                              spec;
  const Outcome first = expect_exit(6, run(command));  // one round decides nothing
  const Outcome second = run(command);
  EXPECT_THAT(first.err, HasSubstr("building HEAD"));
  EXPECT_THAT(first.err, HasSubstr("round 1 of 1"));
  EXPECT_EQ(second.exit_code, 6) << second.out << second.err;
  EXPECT_THAT(second.out, HasSubstr("1 rounds of times; 11 are needed"));
  EXPECT_THAT(second.err, Not(HasSubstr("building")));
  expect_no_worktree(checkout);
}

TEST(CompareProgram, GraphsAreFoundBesideTheSpecification) {
  const ScratchDirectory scratch;
  fs::create_directories(scratch.path("nets"));
  must("{} generate random-cubic -n 20 --count 3 -o " + scratch.path("nets/a.s6"));
  const std::string spec = scratch.write(
      "mine.toml",
      "study = 'mine'\n[[sweep]]\ngraphs = ['nets/*.s6']\nalgorithms = 'grid'\n[[sweep]]\n"
      "graphs = { file = 'nets/a.s6', name = 'a.s6', shuffle = 1 }\nalgorithms = 'diamond'\n");
  const std::string checkout = pretended_checkout(scratch, "true");
  const Outcome outcome =
      expect_exit(6, run("cd " + checkout +
                         " && AR3D_PROGRAM=$(realpath {}) {} compare --base HEAD --rounds 1 "
                         "--study " +
                         spec));  // one round decides nothing
  EXPECT_THAT(outcome.out, HasSubstr("on a.s6"));
}

TEST(CompareProgram, AnInterruptSaysSoAndLeavesNothingBehind) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("tiny.toml", kStudy);
  const std::string checkout = pretended_checkout(scratch, "sleep 20");
  const auto ended_by = [&](const std::string& signal) {
    return run("cd " + checkout + " && timeout --preserve-status -s " + signal +
               " 4 {} compare --base HEAD --study " + spec);
  };
  ended_by("KILL");
  // It goes with the next run, also where git had not made all of it.
  must("cd " + checkout +
       " && git worktree lock $(git worktree list | grep -o '^[^ ]*sources[^ ]*')");
  for (const char* signal : {"INT", "TERM", "HUP"}) {
    expect_error(ended_by(signal), "interrupted while building HEAD", 130);
    expect_no_worktree(checkout);
  }
  expect_error(run("cd " + checkout +
                   " && git commit -q --allow-empty -m quick && mkdir -p build/compare/$(git "
                   "rev-parse HEAD) && cp $(realpath {}) build/compare/$(git rev-parse HEAD)/ar3d "
                   "&& timeout --preserve-status -s INT 3 {} compare --base HEAD --rounds 1000 "
                   "--study " +
                   spec),
               "ar3d: interrupted in round", 130);
  expect_no_worktree(checkout);
}

TEST(CompareProgram, ABuildThatFailsNamesItsLogAndLeavesNoWorktree) {
  const ScratchDirectory scratch;
  const std::string checkout = pretended_checkout(scratch, "false");
  expect_error(run("cd " + checkout + " && {} compare --base HEAD"), ".log");
  expect_no_worktree(checkout);
}

TEST(CompareProgram, ATurnIsShortAndUncounted) {
  const std::string sweep = "[[sweep]]\nfamilies = 'cycle'\nsizes = 9\nalgorithms = 'grid'\n";
  const auto turn_of = [](const std::string& text) {
    return parse_study(text_of_a_turn(parse_study(text, "t"), 5), "turn");
  };
  const StudySpec turn =
      turn_of("study = 't'\ncount = true\n" + sweep + "timed_repetitions = { precision = 0.1 }\n" +
              sweep + "timed_repetitions = 3\n" + sweep);
  EXPECT_FALSE(turn.count);
  ASSERT_EQ(turn.sweeps.size(), 3u);
  EXPECT_EQ(turn.sweeps[0].most_timed, 5u);
  EXPECT_EQ(turn.sweeps[0].least_timed, 5u);
  EXPECT_EQ(turn.sweeps[1].most_timed, 3u);
  EXPECT_EQ(turn.sweeps[2].most_timed, 0u);
  EXPECT_EQ(turn_of("study = 't'\n" + sweep).text, "study = 't'\n" + sweep);
}

}  // namespace
}  // namespace ar3d::testing
