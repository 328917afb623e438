// Files appear whole and durably, whatever kills the program (base/new_file.h), be it with a file
// system that has files without a name or without.
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

}  // namespace
}  // namespace ar3d::testing
