// `ar3d compare --base` on real builds whose drawings are slower by known shares, on this machine
// as it is and under load: what is slower by 10 % or more never passes.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/checkouts.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

/// A build that differs in one function, which draws slower where AR3D_SLOWER asks for it.
std::string slower_program(const ScratchDirectory& scratch) {
  const std::string program = scratch.path("slower");
  expect_exit(0, run(fmt::format(
                     "/usr/bin/python3 {0}/tests/apps/slower_program.py {0} $(realpath {{}}) {1}",
                     AR3D_SOURCE_DIR, program)));
  return program;
}

TEST(SlowBuilds, OfTenPerCentOrMoreNeverPass) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write(
      "slow.toml",
      "study = 'slow'\n[[sweep]]\nfamilies = ['random-cubic', 'cycle']\nsizes = [1000, 2000]\n"
      "algorithms = ['grid', 'two-bend']\ninstances = 4\nrepetitions = 3\n");
  const std::string checkout = pretended_checkout(scratch, "true");
  const std::string load =
      "for i in 1 2; do timeout 600 sh -c 'while :; do :; done' & done; trap 'kill %1 %2' EXIT; ";
  const std::string program = slower_program(scratch);
  for (const int percent : {3, 5, 10, 20, 50}) {
    for (const bool is_loaded : {false, true}) {
      const std::string verdict = scratch.path("verdict.json");
      const Outcome outcome = run(
          (is_loaded ? load : "") + "cd " + checkout +
          fmt::format(" && AR3D_SLOWER='all {} wait' ", percent) + "AR3D_PROGRAM=$(realpath {}) " +
          program + " compare --base HEAD --study " + spec + " --force --json " + verdict);
      const auto json = nlohmann::json::parse(read_file(verdict));
      fmt::print("{} % slower, {}: {} (exit {})\n", percent, is_loaded ? "loaded" : "as it is",
                 json.at("verdict").dump(), outcome.exit_code);
      if (percent >= 10) {
        EXPECT_TRUE(outcome.exit_code == 3 || outcome.exit_code == 6)
            << percent << " %: " << outcome.exit_code << outcome.out << outcome.err;
      }
    }
  }
}

/// The bench of the rates in results/reference/rates.md in a short form: by times, quiet and
/// loaded, and by counts, which find what they are to find whatever the machine.
TEST(SlowBuilds, AmongFilesNothingElseIsNamedAndCountsFindThem) {
  const Outcome rates = expect_exit(
      0, run("/usr/bin/python3 " AR3D_SOURCE_DIR
             "/bench/compare/rates $(realpath {}) --files 3 --slowed 2 --percents 5 20"));
  fmt::print("{}", rates.out);
  for (const char* line : {"The quiet kind", "The loaded kind", "| nothing changed | 3 |",
                           "| `grid` 20 % slower | 6 |", "| 8 of 8 | 16 of 16 |"}) {
    EXPECT_THAT(rates.out, HasSubstr(line));
  }
}

/// The bench of turns in a short form: the same is never told apart, half more time and a bend are.
TEST(SlowBuilds, VersionsInTurnsAreToldApart) {
  const Outcome rates = expect_exit(
      0, run("/usr/bin/python3 " AR3D_SOURCE_DIR
             "/bench/compare/turn_rates $(realpath {}) --same 3 --slowed 2 --pairs --what "
             "'the same' 'slower by 50 %' 'one bend more'"));
  fmt::print("{}", rates.out);
  for (const char* kind : {"commands", "settings", "commits"}) {
    EXPECT_THAT(rates.out, HasSubstr(fmt::format("| {} | the same | 3 | ", kind)));
  }
}

}  // namespace
}  // namespace ar3d::testing
