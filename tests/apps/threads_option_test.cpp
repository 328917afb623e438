// What comes out of the program is the same on any number of threads.
#include "support/program.h"

namespace ar3d::testing {
namespace {

TEST(Threads, OneLargeDrawingAndManySmallOnes) {
  const ScratchDirectory scratch;
  const std::string large = scratch.path("large.s6");
  const std::string small = scratch.path("small.s6");
  must("{} generate random-4-regular -n 66000 -o " + large);
  must("{} generate random-cubic -n 20 --count 30 -o " + small);
  for (const std::string& file : {large, small}) {
    const auto drawn = [&](const std::string& threads) {
      return run("{} draw " + file + " --algorithm diamond --level extents" + threads);
    };
    const Outcome alone = expect_exit(0, drawn(" --threads 1"));
    EXPECT_THAT(alone.out, HasSubstr("\"proved\""));
    for (const char* threads : {" --threads 2", " --threads 3", ""}) {
      EXPECT_EQ(drawn(threads).out, alone.out) << threads;
    }
  }
}

TEST(Threads, VerifyAndUsage) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("d.jsonl");
  must("{} generate random-cubic -n 20 --count 5 | {} draw - --algorithm diamond -o " + file);
  for (const char* threads : {"1", "2", "3"}) {
    const Outcome outcome = expect_exit(0, run("{} verify " + file + " --threads " + threads));
    EXPECT_EQ(outcome.out, "5 certified, 0 violated, 0 not drawn\n");
  }
  for (const char* threads : {"0", "-1", "two", "100000"}) {
    expect_exit(2, run("{} verify " + file + " --threads " + threads));
  }
}

}  // namespace
}  // namespace ar3d::testing
