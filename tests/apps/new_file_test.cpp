// Files appear whole and durably, whatever kills the program (base/new_file.h), be it with a file
// system that has files without a name or without.
#include "ar3d/base/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include "support/program.h"

namespace ar3d::testing {
namespace {

constexpr int kKilled = 128 + 9;

std::size_t entries(const ScratchDirectory& scratch) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(scratch.path("")), fs::directory_iterator()));
}

// The calls are write, fsync, link, rename, fsync of the folder.
TEST(NewFile, IsWholeOrAbsentWhereverTheProgramIsKilled) {
  const std::string whole = run("{} generate cycle -n 5").out;
  for (int call = 1; call <= 6; ++call) {
    const ScratchDirectory scratch;
    const std::string path = scratch.path("g.s6");
    const int exit_code =
        run(with_fault("before:" + std::to_string(call)) + " {} generate cycle -n 5 -o " + path)
            .exit_code;
    EXPECT_EQ(exit_code, call <= 5 ? kKilled : 0) << call;
    EXPECT_EQ(fs::exists(path), call > 4) << call;
    EXPECT_EQ(entries(scratch), call <= 3 ? 0u : 1u) << "before it has a name nothing is left";
    if (call > 4) {
      EXPECT_EQ(read_file(path), whole) << call;
    }
  }
}

TEST(NewFile, IsWrittenWhereFilesHaveANameFromTheStart) {
  const ScratchDirectory scratch;
  const std::string path = scratch.path("g.s6");
  expect_exit(0, run(with_fault("nolink:2") + " {} generate cycle -n 5 -o " + path));
  EXPECT_EQ(read_file(path), run("{} generate cycle -n 5").out);
  EXPECT_EQ(entries(scratch), 1u);
}

TEST(NewFile, WhatAKilledProgramLeftIsRemovedByTheNextRun) {
  const ScratchDirectory scratch;
  const std::string path = scratch.path("g.s6"), left = ".partial-77-0123456789abcdef";
  for (const std::string& name : {left, left + left, ".mine" + left, std::string(".partial-7")}) {
    scratch.write("g.s6" + name, "x");
  }
  const NewFile writing(path);  // another process at work
  const std::string held = scratch.path("g.s6.partial-78-0123456789abcdef");
  const std::string self = fmt::format("/proc/self/fd/{}", writing.descriptor());
  ASSERT_EQ(linkat(AT_FDCWD, self.c_str(), AT_FDCWD, held.c_str(), AT_SYMLINK_FOLLOW), 0);
  expect_exit(0, run("{} generate cycle -n 5 -o " + path));
  EXPECT_EQ(entries(scratch), 4u);
  for (const std::string& name : {path, path + ".mine" + left, path + ".partial-7", held}) {
    EXPECT_TRUE(fs::exists(name)) << name;
  }
}

}  // namespace
}  // namespace ar3d::testing
