#include "ar3d/base/nearest_name.h"

#include <gtest/gtest.h>

namespace ar3d::testing {
namespace {

const std::vector<std::string_view> kNames = {"cycle", "path", "random-cubic", "random-4-regular"};

TEST(NearestName, TakesTheFewestChanges) {
  EXPECT_EQ(nearest_name("cycel", kNames), "cycle");  // exchanged
  EXPECT_EQ(nearest_name("paths", kNames), "path");
  EXPECT_EQ(nearest_name("Random_Cubic", kNames), "random-cubic");
  EXPECT_EQ(nearest_name("random-regular", kNames), "random-4-regular");
  EXPECT_EQ(did_you_mean("cycel", kNames), "; did you mean 'cycle'?");
}

TEST(NearestName, NothingThatIsFarAway) {
  EXPECT_EQ(nearest_name("petersen", kNames), std::nullopt);
  EXPECT_EQ(nearest_name("", kNames), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100000, 'c'), kNames), std::nullopt);
  EXPECT_EQ(did_you_mean("petersen", kNames), "");
}

}  // namespace
}  // namespace ar3d::testing
