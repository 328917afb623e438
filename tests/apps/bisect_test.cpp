// `compare --base` and git's bisection in a small repository whose commits are known.
#include <nlohmann/json.hpp>

#include "apps/checkouts.h"
#include "ar3d/bench/measure/environment.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

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
    scratch_.write("cell.toml",
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

  /// Runs a command in the checkout.
  Outcome in_checkout(const std::string& command) const {
    return run("cd " + checkout_ + " && " + command);
  }

  void expect_nothing_left() const { expect_no_worktree(checkout_); }

 private:
  ScratchDirectory scratch_;
  std::string checkout_ = scratch_.path("checkout");
  std::vector<std::string> hashes_;
};

/// What stands before a program to make it use a library of this source.
std::string with_library(const SeededRepository& repository, const std::string& source) {
  const std::string library = repository.path("other.so");
  must("echo '" + source + "' | gcc -shared -fPIC -x c - -o " + library + " -ldl");
  return "LD_PRELOAD=" + library + " exec";
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

bool can_count() { return std::string(build_kind()) != "sanitised"; }

TEST(MoreInstructions, AreFoundBetweenBuildsInOneRoundWhateverTheTimes) {
  if (!can_count()) GTEST_SKIP() << "valgrind cannot run it";
  SeededRepository repository;
  repository.commit("zero", "LD_PRELOAD= exec");
  const std::string slow = more_instructions(repository), file = repository.path("verdict.json");
  must("sed -i '1i count = true' " + repository.path("cell.toml"));
  const auto verdict = [&](int exit_code, const std::string& before) {
    const Outcome outcome = run("cd " + repository.path("checkout") + " && " + before +
                                " {} compare --base HEAD --rounds 1 --force --json " + file +
                                " --study " + repository.path("cell.toml"));
    expect_output(outcome, "by counts (instructions, simulated cache)", exit_code);
    return nlohmann::json::parse(read_file(file)).at("counts");
  };
  EXPECT_EQ(verdict(0, "").at("PASS"), 2);
  EXPECT_EQ(verdict(3, slow).at("REGRESSED"), 2);
  repository.expect_nothing_left();
}

// The lines of docs/history.md as they are printed, but in one round.
TEST(MoreInstructions, AreFoundByGitsBisection) {
  if (!can_count()) GTEST_SKIP() << "valgrind cannot run it";
  SeededRepository repository;
  const std::string fast = "LD_PRELOAD= exec", slow = more_instructions(repository);
  repository.commit("good", fast);
  repository.commit("one", fast);
  repository.commit("does not build", "");
  for (const char* subject : {"three", "four"}) repository.commit(subject, fast);
  for (const char* subject : {"culprit", "six", "bad"}) repository.commit(subject, slow);
  must("sed -i '1i count = true' " + repository.path("cell.toml"));
  repository.in_checkout(
      "git tag GOOD HEAD~7 && git tag BAD && mv ../cell.toml . && "
      "printf 'test -f program.sh && exec ./program.sh \"$@\"' > ar3d && chmod +x ar3d");
  const std::string page = read_file(AR3D_SOURCE_DIR "/docs/history.md");
  const std::size_t begin = page.find("git bisect start"), end = page.find("git bisect reset");
  ASSERT_LT(begin, end);
  std::string lines = page.substr(begin, end - begin);
  lines.insert(lines.find(" --base"), " --rounds 1");
  expect_output(repository.in_checkout(lines), "is the first bad commit");
  EXPECT_EQ(repository.in_checkout("git show -s --format=%s refs/bisect/bad").out, "culprit\n");
  repository.expect_nothing_left();
}

}  // namespace
}  // namespace ar3d::testing
