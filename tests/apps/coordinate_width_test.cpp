// draw --coordinates: drawings that do not fit become errors of their line.
#include "support/program.h"

namespace ar3d::testing {
namespace {

Outcome drawn(const std::string& n, const std::string& coordinates) {
  return run("{} generate random-cubic -n " + n +
             " | {} draw - --algorithm two-bend --coordinates " + coordinates);
}

TEST(Coordinates, ThatTheBoundDoesNotCoverOrThatDoNotFitAreRefused) {
  expect_exit(0, drawn("20", "auto"));
  expect_exit(0, drawn("20", "checked=int16"));
  const Outcome not_proved = expect_exit(2, drawn("20", "proved=int16"));
  EXPECT_THAT(not_proved.err, HasSubstr("20 vertices: the bound proves int16 for at most "));
  EXPECT_THAT(not_proved.out, HasSubstr("\"error\":"));
  expect_error(drawn("1000", "checked=int16"), "above the least one, int16 holds 32767");
  expect_exit(0, drawn("1000", "proved=int32"));
  expect_exit(2, drawn("20", "int16"));
}

}  // namespace
}  // namespace ar3d::testing
