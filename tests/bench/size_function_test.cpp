#include "ar3d/bench/spec/size_function.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

using ::testing::HasSubstr;

std::string time_error(const std::string& text) {
  try {
    SizeFunction::time(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SizeFunction, AddsTermsWithUnits) {
  const SizeFunction limit = SizeFunction::time("2 s + 20 us * n");
  EXPECT_DOUBLE_EQ(limit(0), 2);
  EXPECT_DOUBLE_EQ(limit(100000), 4);
  EXPECT_FALSE(limit.is_constant());
  EXPECT_TRUE(SizeFunction::time("1.5min").is_constant());
  EXPECT_DOUBLE_EQ(SizeFunction::time("1.5min")(7), 90);
  EXPECT_DOUBLE_EQ(SizeFunction::time("1 ns*n^2+1h")(1000), 3600.001);
  EXPECT_DOUBLE_EQ(SizeFunction::memory("64 MiB + 2 kB * n ^ 1.5")(100), 67108864 + 2e6);
}

TEST(SizeFunction, ErrorsNameTheTextAndThePlace) {
  EXPECT_THAT(time_error(""), HasSubstr("a number is expected"));
  EXPECT_THAT(time_error("2"), HasSubstr("'2': '' is not a unit (ns, us, ms, s, min, h)"));
  EXPECT_THAT(time_error("2 MB"), HasSubstr("'MB' is not a unit"));
  EXPECT_THAT(time_error("2 s + "), HasSubstr("a number is expected"));
  EXPECT_THAT(time_error("2 s 3 s"), HasSubstr("'3 s' is not understood"));
  EXPECT_THAT(time_error("2 s * m"), HasSubstr("only n may follow"));
  EXPECT_THAT(time_error("-2 s"), HasSubstr("a number is expected"));
  EXPECT_THAT(time_error("inf s"), HasSubstr("a number is expected"));
  EXPECT_THAT(time_error("2 s * n^"), HasSubstr("a number is expected"));
}

}  // namespace
}  // namespace ar3d
