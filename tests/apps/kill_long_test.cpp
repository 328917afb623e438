#include <gtest/gtest.h>

#include "support/killed_studies.h"

namespace ar3d::testing {
namespace {

TEST(KilledStudies, LoseNothingInFiveHundredKills) { kill_and_resume(500, 2); }

}  // namespace
}  // namespace ar3d::testing
