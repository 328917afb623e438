// What ./ar3d and ./run-tests share: tools/setup.sh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program.h"

namespace ar3d {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;
using testing::ScratchDirectory;

const std::string kSource = "source " AR3D_SOURCE_DIR "/tools/setup.sh; ";

TEST(Launcher, NamesMissingPackagesOnly) {
  const ScratchDirectory scratch;
  const std::string list =
      scratch.write("packages", "# comment\nbash\nno-such-package-xyz  # why\n");
  const Outcome missing = run(kSource + "missing_packages " + list);
  EXPECT_EQ(missing.exit_code, 0) << missing.err;
  EXPECT_EQ(missing.out, " no-such-package-xyz\n");
}

TEST(Launcher, IsSilentWhenNothingIsMissing) {
  const ScratchDirectory scratch;
  const Outcome nothing = run(kSource + "install_packages " + scratch.write("packages", "bash\n"));
  EXPECT_EQ(nothing.exit_code, 0);
  EXPECT_EQ(nothing.out + nothing.err, "");
}

TEST(Launcher, TellsAUserWithoutSudoWhatToType) {
  const ScratchDirectory scratch;
  const std::string list = scratch.write("packages", "no-such-package-xyz\n");
  // A user who is not root on a machine without sudo.
  const std::string user =
      "id() { echo 1000; }; command() { [ \"$2\" != sudo ] && builtin command \"$@\"; }; ";
  const Outcome told = run(kSource + user + "install_packages " + list);
  EXPECT_EQ(told.exit_code, 2);
  EXPECT_THAT(told.err, HasSubstr("Type: sudo apt-get install -y no-such-package-xyz\n"));
}

TEST(Launcher, EveryPackageOfTheListsIsKnown) {
  // The lists are what a fresh machine gets; a misspelt name would only show there.
  const Outcome missing = run(
      kSource + "cd " AR3D_SOURCE_DIR "/tools && missing_packages packages.txt packages-tests.txt");
  EXPECT_EQ(missing.out, "\n") << "not installed here, although the build and the tests need it";
}

}  // namespace
}  // namespace ar3d
