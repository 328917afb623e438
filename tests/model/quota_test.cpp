#include <fstream>

#include "ar3d/base/system_calls.h"
#include "support/program.h"

namespace ar3d {
namespace {

// Groups as a container of 1.5 CPUs within a unit of systemd of 4 sees them, or the unit alone.
TEST(QuotaThreads, AreThoseOfTheLeastQuotaAroundTheProcess) {
  const testing::ScratchDirectory folder;
  const auto write = [&](const std::string& name, const char* text) {
    const testing::fs::path path = folder.path(name);
    testing::fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  };
  write("root/unit/box/cpu.max", "150000 100000\n");
  write("root/unit/cpu.max", "400000 100000\n");
  write("root/unit/free/cpu.max", "max 100000\n");
  write("root/bits/cpu.max", "2000 100000\n");
  write("own", "12:cpuset:/else\n0::/unit/box\n");
  const auto threads = [&](const char* group) {
    write("own", group);
    return quota_threads(folder.path("own"), folder.path("root"));
  };
  EXPECT_EQ(threads("12:cpuset:/else\n0::/unit/box\n"), 2u);
  EXPECT_EQ(threads("0::/unit/free\n"), 4u);
  EXPECT_EQ(threads("0::/bits\n"), 1u);
  EXPECT_EQ(threads("0::/\n"), UINT32_MAX);
  EXPECT_EQ(threads("1:cpu:/unit/box\n"), UINT32_MAX);
  write("root/cpu.max", "300000 100000\n");  // a container that sees its own group as the root
  EXPECT_EQ(threads("0::/\n"), 3u);
  EXPECT_EQ(quota_threads(folder.path("none"), folder.path("nowhere")), UINT32_MAX);
}

}  // namespace
}  // namespace ar3d
