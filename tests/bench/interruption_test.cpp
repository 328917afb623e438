#include "ar3d/bench/measure/interruption.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

namespace ar3d {
namespace {

int g_seen = 0;
void see(int) { ++g_seen; }

TEST(Interruption, IsNotedWhileSomebodyAsksAndForgottenAfterwards) {
  g_seen = 0;
  std::signal(SIGINT, see);
  for (const int signal : {SIGINT, SIGTERM}) {
    const Interruptible interruptible;
    EXPECT_FALSE(is_interrupted());
    std::raise(signal);
    EXPECT_TRUE(is_interrupted());
  }
  EXPECT_FALSE(is_interrupted());
  EXPECT_EQ(g_seen, 0);
  std::raise(SIGINT);  // does what it did before
  EXPECT_EQ(g_seen, 1);
  std::signal(SIGINT, SIG_DFL);
}

TEST(Interruption, ASecondSignalEndsTheProgramOrIsIgnored) {
  const auto interrupted_twice = [](SecondSignal second) {
    const Interruptible interruptible(second);
    std::raise(SIGTERM);
    std::raise(SIGTERM);
    std::exit(is_interrupted() ? 7 : 8);
  };
  EXPECT_EXIT(interrupted_twice(SecondSignal::ends_program), ::testing::KilledBySignal(SIGTERM),
              "");
  EXPECT_EXIT(interrupted_twice(SecondSignal::is_ignored), ::testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace ar3d
