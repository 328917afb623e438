// Children that never answer: who waits for them has a limit. All wait at the same time.
#include <fmt/format.h>

#include "support/program.h"

namespace ar3d::testing {
namespace {

TEST(HangingChildren, AreWaitedForAMinute) {
  const ScratchDirectory scratch;
  must("{} study run smoke -q -o " + scratch.path("r.h5"));
  scratch.write("valgrind", "#!/bin/sh\nsleep 7777\n");
  must("chmod +x " + scratch.path("valgrind"));
  std::string all = "cd " + scratch.path("") + "; ";
  std::size_t waiting = 0;
  const auto begin = [&](const std::string& command) {
    all += fmt::format("(timeout 300 {} > {}.out 2>&1; echo \"exit $?\" >> {}.out) & ", command,
                       waiting, waiting);
    ++waiting;
  };
  for (const char* lie : {"lie:11", "lie:12", "lie:13", "lie:14", "lie:15"}) {
    for (const char* verb : {"check r.h5", "report r.h5", "study merge r.h5 -o m.h5",
                             "study resume -q r.h5", "study status r.h5"}) {
      begin(with_fault(lie) + "{} " + verb);
    }
  }
  begin("env PATH=.:$PATH {} study count r.h5");
  run(all + "wait");
  for (std::size_t i = 0; i < waiting; ++i) {
    const std::string said = read_file(scratch.path(fmt::format("{}.out", i)));
    EXPECT_THAT(said, HasSubstr(i + 1 < waiting ? "r.h5 is damaged: after 60 s of reading"
                                                : "valgrind cannot be run"));
    EXPECT_THAT(said, EndsWith("exit 2\n"));
  }
  EXPECT_FALSE(fs::exists(scratch.path("r.h5.journal")));
}

}  // namespace
}  // namespace ar3d::testing
