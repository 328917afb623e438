// draw --coordinates: drawings that do not fit become errors of their line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/program.h"

namespace ar3d::testing {
namespace {

using ::testing::HasSubstr;

Outcome drawn(const std::string& n, const std::string& coordinates) {
  return run(kProgram + " generate random-cubic -n " + n + " | " + kProgram +
             " draw - --algorithm two-bend --coordinates " + coordinates);
}

TEST(Coordinates, ThatTheBoundDoesNotCoverOrThatDoNotFitAreRefused) {
  EXPECT_EQ(drawn("20", "auto").exit_code, 0);
  EXPECT_EQ(drawn("20", "checked=int16").exit_code, 0);
  const Outcome not_proved = expect_exit(2, drawn("20", "proved=int16"));
  EXPECT_THAT(not_proved.err, HasSubstr("20 vertices: the bound proves int16 for at most "));
  EXPECT_THAT(not_proved.out, HasSubstr("\"error\":"));
  expect_error(drawn("1000", "checked=int16"), "above the least one, int16 holds 32767");
  EXPECT_EQ(drawn("1000", "proved=int32").exit_code, 0);
  EXPECT_EQ(drawn("20", "int16").exit_code, 2);
}

}  // namespace
}  // namespace ar3d::testing
