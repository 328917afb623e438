// What ./ar3d and ./run-tests share: tools/setup.sh.
#include "support/program.h"

namespace ar3d::testing {
namespace {

const std::string kSource = "source " AR3D_SOURCE_DIR "/tools/setup.sh; ";

TEST(Launcher, NamesMissingPackagesOnly) {
  const ScratchDirectory scratch;
  const std::string list =
      scratch.write("packages", "# comment\nbash\nno-such-package-xyz  # why\n");
  const Outcome missing = expect_exit(0, run(kSource + "missing_packages " + list));
  EXPECT_EQ(missing.out, " no-such-package-xyz\n");
}

TEST(Launcher, IsSilentWhenNothingIsMissing) {
  const ScratchDirectory scratch;
  const Outcome nothing =
      expect_exit(0, run(kSource + "install_packages " + scratch.write("packages", "bash\n")));
  EXPECT_EQ(nothing.out + nothing.err, "");
}

TEST(Launcher, TellsAUserWithoutSudoWhatToType) {
  const ScratchDirectory scratch;
  const std::string list = scratch.write("packages", "no-such-package-xyz\n");
  // A user who is not root on a machine without sudo.
  const std::string user =
      "id() { echo 1000; }; command() { [ \"$2\" != sudo ] && builtin command \"$@\"; }; ";
  expect_error(run(kSource + user + "install_packages " + list),
               "Type: sudo apt-get install -y no-such-package-xyz\n");
}

/// A root user with an apt-get that notes its calls in `folder`/calls and whose first `busy`
/// updates find the lists locked; nobody waits in earnest.
std::string fake_apt(const ScratchDirectory& folder, int busy) {
  const std::string script = "#!/bin/bash\necho \"$@\" >> " + folder.path("calls") +
                             "\n[[ \"$*\" != *update ]] || [ $(wc -l < " + folder.path("calls") +
                             ") -gt " + std::to_string(busy) +
                             " ] || { echo 'E: Could not get lock /var/lib/apt/lists/lock.' >&2; "
                             "exit 100; }\necho much talk\n";
  folder.write("apt-get", script);
  return "chmod +x " + folder.path("apt-get") + "; PATH=" + folder.path("") +
         ":$PATH; id() { echo 0; }; sleep() { :; }; ";
}

TEST(Launcher, SaysWhatItInstallsAndWaitsForABusyPackageManager) {
  const ScratchDirectory scratch;
  const std::string list = scratch.write("packages", "no-such-package-xyz\nbash\nno-such-too\n");
  const Outcome done =
      expect_exit(0, run(kSource + fake_apt(scratch, 3) + "install_packages " + list));
  EXPECT_EQ(done.out, "");
  EXPECT_EQ(done.err,
            "ar3d: installing with apt-get: no-such-package-xyz no-such-too\n"
            "ar3d: waiting for another package manager\n");
  const std::string calls = read_file(scratch.path("calls"));
  EXPECT_EQ(std::count(calls.begin(), calls.end(), '\n'), 5) << "four updates, one install";
  EXPECT_THAT(calls,
              HasSubstr("DPkg::Lock::Timeout=600 install -y no-such-package-xyz no-such-too"));
}

TEST(Launcher, ShowsWhatAptSaidWhenItFails) {
  const ScratchDirectory scratch;
  const std::string list = scratch.write("packages", "no-such-package-xyz\n");
  expect_error(run(kSource + fake_apt(scratch, 1000) + "install_packages " + list),
               {"E: Could not get lock /var/lib/apt/lists/lock.",
                "Type: sudo apt-get install -y no-such-package-xyz\n"});
}

TEST(Launcher, AnyNpmWillDo) {
  // Other packages of Node bring npm and exclude Debian's.
  const ScratchDirectory scratch;
  const std::string none = "dpkg-query() { echo unknown; }; ";
  const std::string list = scratch.write("packages", "npm  # any\n");
  EXPECT_EQ(run(kSource + none + "npm() { :; }; missing_packages " + list).out, "\n");
  EXPECT_EQ(
      run(kSource + none +
          "command() { [ \"$2\" != npm ] && builtin command \"$@\"; }; missing_packages " + list)
          .out,
      " npm\n");
}

TEST(Launcher, ALongBuildSaysHowFarItIs) {
  const ScratchDirectory scratch;
  const Outcome built = run(kSource + "log=" + scratch.path("log") +
                            "; { sleep 2.5; echo '[3/10] a' >> $log; sleep 1; echo '[10/10] b' >> "
                            "$log; sleep 1; } & touch $log; report_progress $! $log release");
  EXPECT_EQ(built.out, "");
  EXPECT_EQ(built.err,
            "ar3d: building (release), the first time takes minutes\n"
            "ar3d: building (release), 30 %\n"
            "ar3d: building (release), 100 %\n");
  EXPECT_EQ(run(kSource + "sleep 0.1 & report_progress $! /dev/null release").err, "")
      << "a short one says nothing";
}

TEST(Launcher, EveryPackageOfTheListsIsKnown) {
  // The lists are what a fresh machine gets; a misspelt name would only show there.
  const Outcome missing =
      run(kSource + "cd " AR3D_SOURCE_DIR
                    "/tools && missing_packages packages.txt packages-tests.txt "
                    "packages-lint.txt");
  EXPECT_EQ(missing.out, "\n") << "not installed here, although the build and the tests need it";
}

}  // namespace
}  // namespace ar3d::testing
