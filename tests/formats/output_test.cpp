#include "ar3d/formats/text/output.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "formats/format_helpers.h"

namespace ar3d::testing {
namespace {

std::string refusal_to_write(const std::string& path, const std::string& text) {
  return problem(
      [&] {
        OutputFile output(path);
        output.append(text);
        output.commit();
      },
      "accepted");
}

TEST(OutputFile, AppearsOnlyWhenComplete) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  const std::string path = folder.path("out");
  folder.write("out", "old");
  {
    OutputFile output(path);
    output.append(std::string(1 << 20, 'x'));
    EXPECT_EQ(read_file(path), "old");
  }  // given up
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(folder.entries(), 1u);
  OutputFile output(path);
  output.append("new");
  output.commit();
  EXPECT_EQ(read_file(path), "new");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(OutputFile, KeepsModeAndFollowsLinks) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  folder.write("target", "old");
  ::chmod(folder.path("target").c_str(), 0640);
  fs::create_symlink("target", folder.path("link"));
  EXPECT_EQ(refusal_to_write(folder.path("link"), "new"), "accepted");
  EXPECT_TRUE(fs::is_symlink(folder.path("link")));
  EXPECT_EQ(read_file(folder.path("target")), "new");
  struct stat status {};
  ::stat(folder.path("target").c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(OutputFile, RefusesWhatCannotBeWritten) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  EXPECT_EQ(refusal_to_write(folder.path(""), "x"),
            "cannot write " + folder.path("") + ": Is a directory");
  EXPECT_EQ(refusal_to_write(folder.path("no/such/file"), "x"),
            "cannot write " + folder.path("no/such/file") + ": No such file or directory");
  EXPECT_EQ(refusal_to_write("/dev/full", "x"), "cannot write /dev/full: No space left on device");
  EXPECT_EQ(refusal_to_write("/dev/null", "x"), "accepted");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputFile, FullDiskLeavesNothingBehind) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{1 << 17, old.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = refusal_to_write(folder.path("out"), std::string(1 << 20, 'x'));
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, "cannot write " + folder.path("out") + ": File too large");
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace ar3d::testing
