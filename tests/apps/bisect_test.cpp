// `ar3d bisect` in a small repository whose commits are known.
#include <nlohmann/json.hpp>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/store/run_storage.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

constexpr const char* kCell = "'grid (effort=1) on cycle n=50'";

/// A checkout of which every commit "builds" its file program.sh as the program.
class SeededRepository {
 public:
  SeededRepository() {
    fs::create_directories(checkout_ + "/apps");
    scratch_.write("checkout/apps/study.cpp", "");
    scratch_.write("checkout/CMakeLists.txt",
                   "cmake_minimum_required(VERSION 3.20)\nproject(seeded NONE)\n"
                   "add_custom_target(ar3d_program COMMAND ${CMAKE_COMMAND} -E make_directory apps "
                   "COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_SOURCE_DIR}/program.sh apps/ar3d)\n");
    scratch_.write("tiny.toml",
                   "study = 'tiny'\n[[sweep]]\nfamilies = ['cycle', 'random-cubic']\nsizes = 50\n"
                   "algorithms = 'grid'\n");
    expect_exit(0, run("git init -q " + checkout_));
  }

  /// A commit whose program runs `command` in front of the program of this test.
  /// @param command  empty: it cannot be built.
  void commit(const std::string& subject, const std::string& command) {
    const std::string script = checkout_ + "/program.sh";
    fs::remove(script);
    if (!command.empty()) {
      const Outcome program = run("realpath {}");
      scratch_.write("checkout/program.sh", "#!/bin/bash\n# " + subject + "\n" + command + " " +
                                                program.out.substr(0, program.out.size() - 1) +
                                                " \"$@\"\n");
      expect_exit(0, run("chmod +x " + script));
    }
    const Outcome made =
        expect_exit(0, run("cd " + checkout_ +
                           " && git add -A && git -c user.name=t -c user.email=t@t commit "
                           "--allow-empty -qm '" +
                           subject + "' && git rev-parse HEAD"));
    hashes_.push_back(made.out.substr(0, 40));
  }

  const std::string& hash(std::size_t commit) const { return hashes_[commit]; }
  std::string path(const std::string& name) const { return scratch_.path(name); }

  Outcome bisect(const std::string& arguments, const std::string& before = "") const {
    return run("cd " + checkout_ + " && " + before + " {} bisect --study " +
               scratch_.path("tiny.toml") + " " + arguments);
  }

  void expect_nothing_left() const {
    const Outcome trees = run("git -C " + checkout_ + " worktree list");
    EXPECT_EQ(std::count(trees.out.begin(), trees.out.end(), '\n'), 1) << trees.out;
    for (const auto& entry : fs::directory_iterator(checkout_ + "/build/compare")) {
      EXPECT_THAT(entry.path().string(), Not(HasSubstr("sources")));
      EXPECT_THAT(entry.path().string(), Not(HasSubstr("run-")));
    }
  }

 private:
  ScratchDirectory scratch_;
  std::string checkout_ = scratch_.path("checkout");
  std::vector<std::string> hashes_;
};

/// Draws with another effort than it is told to, so that the boxes are other ones.
constexpr const char* kOtherDrawings =
    "for word in \"$@\"; do [[ $word == *.toml ]] && sed -i 's/effort = 1/effort = 0/' \"$word\"; "
    "done;";
constexpr const char* kPlain = "exec";

TEST(Bisect, TheCommitThatChangedTheDrawingsIsFoundAndNothingIsLeft) {
  SeededRepository repository;
  for (const char* subject : {"zero", "one", "two", "three"}) repository.commit(subject, kPlain);
  for (const char* subject : {"culprit", "five", "six"}) {
    repository.commit(subject, kOtherDrawings);
  }
  expect_output(repository.bisect("--measure volume --good " + repository.hash(0) +
                                  " --bad HEAD --cell " + kCell),
                {"FOUND    " + repository.hash(4) + " culprit", "6 to look among"});
  repository.expect_nothing_left();

  expect_output(repository.bisect("--measure bends --good " + repository.hash(0) + " --bad " +
                                  repository.hash(3) + " --cell " + kCell),
                "NO CHANGE", 6);
}

TEST(Bisect, CommitsThatDoNotBuildOrRunAreSkippedAndNamed) {
  SeededRepository repository;
  repository.commit("zero", kPlain);
  repository.commit("does not build", "");
  repository.commit("does not run", "exit 1;");
  repository.commit("last", kOtherDrawings);
  const Outcome outcome = expect_exit(
      6, repository.bisect("--measure volume --good HEAD~3 --cell " + std::string(kCell)));
  EXPECT_THAT(outcome.out, HasSubstr("SKIPPED  " + repository.hash(1).substr(0, 12)));
  EXPECT_THAT(outcome.out, HasSubstr("SKIPPED  " + repository.hash(2).substr(0, 12)));
  for (const std::size_t i : {1, 2, 3}) {
    EXPECT_THAT(outcome.out, HasSubstr("PERHAPS  " + repository.hash(i)));
  }
  repository.expect_nothing_left();
}

/// What stands before a program to make it use a library of this source.
std::string with_library(const SeededRepository& repository, const std::string& source) {
  const std::string library = repository.path("other.so");
  must("echo '" + source + "' | gcc -shared -fPIC -x c - -o " + library + " -ldl");
  return "LD_PRELOAD=" + library + " exec";
}

/// Clocks (wall and CPU time of a thread) that run twice as fast: drawing takes twice the time.
std::string fast_clock(const SeededRepository& repository) {
  return with_library(repository, R"(#define _GNU_SOURCE
#include <dlfcn.h>
#include <time.h>
int clock_gettime(clockid_t id, struct timespec* t) {
  static int (*real)(clockid_t, struct timespec*);
  if (!real) real = dlsym(RTLD_NEXT, "clock_gettime");
  int code = real(id, t);
  if (id != CLOCK_MONOTONIC && id != CLOCK_THREAD_CPUTIME_ID) return code;
  long long ns = 2 * (t->tv_sec * 1000000000LL + t->tv_nsec);
  t->tv_sec = ns / 1000000000; t->tv_nsec = ns % 1000000000;
  return code;
})");
}

/// Allocations that take 200 steps each: the same drawings by more instructions.
std::string more_instructions(const SeededRepository& repository) {
  return with_library(repository, R"(#include <stddef.h>
extern void* __libc_malloc(size_t);
void* malloc(size_t size) {
  for (volatile int i = 0; i < 200; ++i);
  return __libc_malloc(size);
})");
}

TEST(Bisect, TheCommitThatMadeItSlowerIsFound) {
  SeededRepository repository;
  const std::string slow = fast_clock(repository);
  for (const char* subject : {"zero", "one", "two"}) repository.commit(subject, kPlain);
  for (const char* subject : {"slow", "four"}) repository.commit(subject, slow);
  expect_output(repository.bisect("--rounds 8 --good HEAD~4 --cell " + std::string(kCell)),
                "FOUND    " + repository.hash(3) + " slow");
  repository.expect_nothing_left();
}

/// Two results of the study in a history, as of the first commit and of the last, and what the
/// command finds that the history prints of the measure. @param change  of the second's rows.
template <class Change>
Outcome found_by_history(const SeededRepository& repository, const std::string& measure,
                         const Change& change) {
  const std::string path = repository.path("now.h5"), folder = repository.path("history");
  const std::string cd = "cd " + repository.path("checkout") + " && ";
  must("{} study run -q --threads 1 " + repository.path("tiny.toml") + " -o " + path);
  for (const std::size_t commit : {0, 3}) {
    if (commit == 3) change(path);
    Results results = read_results(path);
    results.source_hash = repository.hash(commit);
    results.dirty = false;
    write_results(results, path);
    must(cd + "{} history add " + path + " --folder " + folder);
  }
  const Outcome report = run("{} history report --folder " + folder);
  for (std::size_t at = 0; (at = report.out.find("ar3d bisect ", at)) != std::string::npos; ++at) {
    const std::string command = report.out.substr(at + 5, report.out.find('\n', at) - at - 5);
    if (command.find("--measure " + measure) == std::string::npos) continue;
    if (command.ends_with(kCell)) return run(cd + "{} " + command);
  }
  throw std::runtime_error("no such command: " + report.out);
}

TEST(Bisect, TheCommandThatAHistoryPrintsFindsTheCommit) {
  SeededRepository repository;
  for (const char* subject : {"zero", "one"}) repository.commit(subject, kPlain);
  for (const char* subject : {"culprit", "three"}) repository.commit(subject, kOtherDrawings);
  const auto grow = [](const std::string& path) {
    Results results = read_results(path);
    results.runs.front().extents[0] += 1;
    write_results(results, path);
  };
  expect_output(found_by_history(repository, "volume", grow),
                "FOUND    " + repository.hash(2) + " culprit");
}

bool can_count() { return std::string(build_kind()) != "sanitised"; }

TEST(MoreInstructions, AreFoundByBisection) {
  if (!can_count()) GTEST_SKIP() << "valgrind cannot run it";
  SeededRepository repository;
  repository.commit("zero", kPlain);
  repository.commit("culprit", more_instructions(repository));
  const std::string range = "--good HEAD~1 --cell " + std::string(kCell);
  expect_output(repository.bisect("--measure cycles " + range),
                {"FOUND    " + repository.hash(1) + " culprit", "BAD      cycles +"});
  expect_output(repository.bisect("--measure volume " + range), "NO CHANGE", 6);
  repository.expect_nothing_left();
}

TEST(MoreInstructions, AreFoundByTheCommandThatAHistoryPrints) {
  if (!can_count()) GTEST_SKIP() << "valgrind cannot run it";
  SeededRepository repository;
  const std::string slow = more_instructions(repository);
  for (const char* subject : {"zero", "one"}) repository.commit(subject, kPlain);
  for (const char* subject : {"culprit", "three"}) repository.commit(subject, slow);
  must("sed -i '1i count = true' " + repository.path("tiny.toml"));
  const auto count_again = [&](const std::string& path) {
    must(slow.substr(0, slow.find(' ')) + " {} study count " + path);
  };
  expect_output(found_by_history(repository, "instructions", count_again),
                {"FOUND    " + repository.hash(2) + " culprit", "BAD      instructions +"});
}

TEST(MoreInstructions, AreFoundBetweenBuildsInOneRoundWhateverTheTimes) {
  if (!can_count()) GTEST_SKIP() << "valgrind cannot run it";
  SeededRepository repository;
  repository.commit("zero", "LD_PRELOAD= exec");
  const std::string slow = more_instructions(repository), file = repository.path("verdict.json");
  must("sed -i '1i count = true' " + repository.path("tiny.toml"));
  const auto verdict = [&](int exit_code, const std::string& before) {
    const Outcome outcome = run("cd " + repository.path("checkout") + " && " + before +
                                " {} compare --base HEAD --rounds 1 --force --json " + file +
                                " --study " + repository.path("tiny.toml"));
    expect_output(outcome, "by counts (instructions, simulated cache)", exit_code);
    return nlohmann::json::parse(read_file(file)).at("counts");
  };
  EXPECT_EQ(verdict(0, "").at("PASS"), 2);
  EXPECT_EQ(verdict(3, slow).at("REGRESSED"), 2);
  repository.expect_nothing_left();
}

TEST(Bisect, AnInterruptLeavesNoWorktree) {
  SeededRepository repository;
  repository.commit("zero", kPlain);
  repository.commit("endless", "exec sleep 600;");
  expect_error(repository.bisect("--measure volume --good HEAD~1 --cell " + std::string(kCell),
                                 "timeout --preserve-status -s INT 6"),
               "ar3d: interrupted", 130);
  repository.expect_nothing_left();
}

TEST(Bisect, BadInputIsOneClearLine) {
  SeededRepository repository;
  repository.commit("zero", kPlain);
  repository.commit("one", kPlain);
  const std::string range = "--good HEAD~1 --cell ";
  for (const auto& [arguments, message] : std::vector<std::pair<std::string, std::string>>{
           {range + "'grid (effort=1) on cycle n=51'", "has no cell"},
           {range + "'grid (effort=1) on cycle n=51'", "did you mean 'grid (effort=1) on cycle n="},
           {"--good no-such-ref --cell " + std::string(kCell), "no commit 'no-such-ref'"},
           {"--good HEAD --bad HEAD~1 --cell " + std::string(kCell), "is no earlier commit than"},
           {"--good HEAD --bad HEAD --cell " + std::string(kCell), "is no earlier commit than"},
           {"--good HEAD~1", "--cell"},
           {range + kCell + std::string(" --measure speed"), "speed"},
           {range + kCell + std::string(" --rounds 3"), "--rounds"}}) {
    expect_one_line(repository.bisect(arguments), message);
  }
}

}  // namespace
}  // namespace ar3d::testing
