// The tables of docs/precision.md: their commands run, and say what the page says of them.
#include "support/program.h"

namespace ar3d::testing {
namespace {

Outcome precision(const std::string& arguments) {
  return run(std::string(AR3D_PRECISION) + " " + arguments);
}

/// The commands of docs/precision.md; the tables of `all` take minutes and are not made here.
TEST(PrecisionTables, AllTakesAPictureAndTheWholeReportIsOneCommand) {
  EXPECT_THAT(precision("--help").out, HasSubstr("--picture"));
  const ScratchDirectory scratch;
  const std::string study =
      scratch.write("s.toml",
                    "study = \"few\"\n[[sweep]]\nfamilies = \"cycle\"\nsizes = 5\n"
                    "algorithms = \"grid\"\n");
  const std::string tables = scratch.write("tables", "#!/bin/sh\necho \"$@\"\ntouch \"$3\"\n");
  const std::string command = "chmod +x " + tables + " && AR3D=" + AR3D_PROGRAM +
                              " AR3D_PRECISION=" + tables + " " + AR3D_SOURCE_DIR +
                              "/tools/precision-report " + scratch.path("report") + " " + study;
  const Outcome outcome = expect_exit(0, run(command));
  EXPECT_THAT(outcome.out, ContainsRegex("tables.md and signs.svg in .*report: [0-9]+ s"));
  EXPECT_EQ(run("cat " + scratch.path("report/tables.md")).out,
            "all --picture " + scratch.path("report/signs.svg") + "\n");
  for (const char* file : {"precision.h5", "precision.html", "signs.svg"}) {
    expect_exit(0, run("test -e " + scratch.path(std::string("report/") + file)));
  }
  expect_exit(2, run(command));  // the folder exists
}

TEST(PrecisionTables, WidthsFollowFromTheBounds) {
  const Outcome outcome = expect_exit(0, precision("widths"));
  EXPECT_THAT(outcome.out, HasSubstr("| `diamond` | 4095 |"));  // 8 n <= 2^15 - 1
  EXPECT_THAT(outcome.out, HasSubstr("| 268435455 |"));
}

// The range check: nothing is wrong that it proves. Doubles hold 53 bits.
TEST(PrecisionTables, PredicatesAreRightWhereTheRangeCheckProvesThem) {
  const Outcome outcome = expect_exit(0, precision("predicates"));
  EXPECT_THAT(outcome.out, ContainsRegex("`two-bend` \\| 100 \\| angle as drawn \\| 49 \\| [^|]* "
                                         "\\| 0 "));
  EXPECT_THAT(outcome.out,
              ContainsRegex("`two-bend` \\| 100000 \\| angle, one unit off \\| 130 \\| "
                            "[^|]* \\| [1-9][^|]*%"));
}

TEST(PrecisionTables, FarFromTheOriginMissesGrowAsPredicted) {
  expect_output(precision("shift"), "| double | 1e-06 | 2^26 to 2^27 | 2^27 |");
}

// Seen onsets lie in the predicted band, or a level or two beside it.
TEST(PrecisionTables, NestsMissFromTheDepthThatTheConditionPredicts) {
  expect_output(
      precision("nests --depth 12"),
      {"| hexagons in K4 | float | 0.01 |", "| heptagons in C5 | double | broken |  | > 12 |",
       "| hexagons in the cube | float | 0.01 |",
       "| heptagons, then as many hexagons, in C5 | float | 0.01 |"});
}

TEST(PrecisionTables, MapsOfWrongSigns) {
  const ScratchDirectory scratch;
  const std::string picture = scratch.path("signs.svg");
  const Outcome outcome = expect_exit(0, precision("signs --picture " + picture));
  EXPECT_THAT(outcome.out, HasSubstr("| double | as drawn, steps of 1 | 0 (< "));
  EXPECT_THAT(outcome.out, ContainsRegex("\\| float \\| as drawn, steps of 1 \\| [0-9.e-]+ % "));
  EXPECT_THAT(read_file(picture), HasSubstr("fill='#000'"));
  expect_exit(2, precision("signs --picture " + picture));
}

}  // namespace
}  // namespace ar3d::testing
