// The tables of docs/precision.md: their commands run, and say what the page says of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/program.h"

namespace ar3d {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;

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

TEST(PrecisionTables, WrongAnglesBeginWhereRoundingCanMatter) {
  const Outcome outcome = precision("onset --most 300");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("| `two-bend` | float | 128 | 180 |"));
  EXPECT_THAT(outcome.out, HasSubstr("| `two-bend` | double | > 300 | > 300 |"));
}

TEST(PrecisionTables, FarFromTheOriginMissesGrowAsPredicted) {
  const Outcome outcome = precision("shift");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("| double | 1e-06 | 2^26 to 2^27 | 2^27 |"));
}

}  // namespace
}  // namespace ar3d
