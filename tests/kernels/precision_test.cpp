// The tables of docs/precision.md: their commands run, and say what the page says of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/program.h"

namespace ar3d::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

Outcome precision(const std::string& arguments) {
  return run(std::string(AR3D_PRECISION) + " " + arguments);
}

TEST(PrecisionTables, SayWhatEachModeCatches) {
  const Outcome outcome = precision("damage --drawings 2");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("96 drawings, "));
  // Wrong angles are seen by all but none; exact sees everything.
  EXPECT_THAT(outcome.out,
              ContainsRegex("a vertex moved by 1 \\| as drawn \\| 8 \\| 100 % [^|]*\\| 100 % [^|]*"
                            "\\| 100 % [^|]*\\| 100 % [^|]*\\| 100 % [^|]*\\| 0 "));
  EXPECT_EQ(precision("damage --drawings 2").out, outcome.out) << "a function of the command";
  EXPECT_EQ(precision("damage --drawings 0").exit_code, 2);
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
  const Outcome outcome = run(command);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("tables.md and signs.svg in .*report: [0-9]+ s"));
  EXPECT_EQ(run("cat " + scratch.path("report/tables.md")).out,
            "all --picture " + scratch.path("report/signs.svg") + "\n");
  for (const char* file : {"precision.h5", "precision.html", "signs.svg"}) {
    EXPECT_EQ(run("test -e " + scratch.path(std::string("report/") + file)).exit_code, 0) << file;
  }
  EXPECT_EQ(run(command).exit_code, 2) << "the folder exists";
}

TEST(PrecisionTables, WidthsFollowFromTheBounds) {
  const Outcome outcome = precision("widths");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("| `diamond` | 4095 |"));  // 8 n <= 2^15 - 1
  EXPECT_THAT(outcome.out, HasSubstr("| 268435455 |"));
}

// The range check: nothing is wrong that it proves. Doubles hold 53 bits.
TEST(PrecisionTables, PredicatesAreRightWhereTheRangeCheckProvesThem) {
  const Outcome outcome = precision("predicates");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ContainsRegex("`two-bend` \\| 100 \\| angle as drawn \\| 49 \\| [^|]* "
                                         "\\| 0 "));
  EXPECT_THAT(outcome.out,
              ContainsRegex("`two-bend` \\| 100000 \\| angle, one unit off \\| 130 \\| "
                            "[^|]* \\| [1-9][^|]*%"));
}

TEST(PrecisionTables, FarFromTheOriginMissesGrowAsPredicted) {
  const Outcome outcome = precision("shift");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("| double | 1e-06 | 2^26 to 2^27 | 2^27 |"));
}

// Seen onsets lie in the predicted band, or a level or two beside it.
TEST(PrecisionTables, NestsMissFromTheDepthThatTheConditionPredicts) {
  const Outcome outcome = precision("nests --depth 12");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("| hexagons in K4 | float | 0.01 |"));
  EXPECT_THAT(outcome.out, HasSubstr("| heptagons in C5 | double | broken |  | > 12 |"));
  EXPECT_THAT(outcome.out, HasSubstr("| hexagons in the cube | float | 0.01 |"));
  EXPECT_THAT(outcome.out, HasSubstr("| heptagons, then as many hexagons, in C5 | float | 0.01 |"));
}

TEST(PrecisionTables, MapsOfWrongSigns) {
  const ScratchDirectory scratch;
  const std::string picture = scratch.path("signs.svg");
  const Outcome outcome = precision("signs --picture " + picture);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("| double | as drawn, steps of 1 | 0 (< "));
  EXPECT_THAT(outcome.out, ContainsRegex("\\| float \\| as drawn, steps of 1 \\| [0-9.e-]+ % "));
  EXPECT_THAT(read_file(picture), HasSubstr("fill='#000'"));
  EXPECT_EQ(precision("signs --picture " + picture).exit_code, 2) << "it exists";
}

}  // namespace
}  // namespace ar3d::testing
