// A collection like the Rome graphs from beginning to end: 11,534 files, every algorithm and a
// program of another author, the report and the gate. What it takes is printed, not judged.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "ar3d/algorithms/catalog.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

class RomeLike : public ::testing::Test {
 protected:
  /// The command's outcome; prints how long it took.
  Outcome timed(const char* what, const std::string& command) const {
    const auto begin = std::chrono::steady_clock::now();
    Outcome outcome = run("cd " + scratch_.path("") + " && " + command);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::printf("%s: %.1f s\n", what, seconds.count());
    return outcome;
  }
  ScratchDirectory scratch_;
};

TEST_F(RomeLike, IsPlannedDrawnReportedAndGated) {
  const std::string tests = AR3D_SOURCE_DIR "/tests/apps/";
  must("python3 " + tests + "rome_like.py " + scratch_.path("rome"));
  scratch_.write("rome/README", "These are graphs.\n");
  scratch_.write("rome.toml", R"(study = "rome"
[[algorithm]]
name = "moment-curve"
command = ["python3", ")" + tests +
                                  R"(moment_curve.py"]
[[sweep]]
graphs = { files = "rome", name = "rome", skip = true }
algorithms = ["all", "moment-curve"]
)");
  std::size_t proved = 0;
  std::size_t rows = 11534;  // of the program
  for (const Algorithm* algorithm : proved_algorithms()) {
    rows += 11534;
    proved += 11534 - (algorithm->guarantee.max_degree == 3 ? 9122 : 4993);
  }
  const Outcome plan = expect_exit(0, timed("plan", "{} study plan rome.toml"));
  EXPECT_THAT(plan.out, AllOf(HasSubstr("rome: 11534 graphs, 9122 of degree above 3, 4993 of "
                                        "degree above 4, 1 files left out"),
                              HasSubstr(fmt::format("11534 instances, {} rows", rows))));
  const Outcome made = timed("run, with its report", "{} study run -q rome.toml");
  EXPECT_THAT(made.out, HasSubstr(fmt::format("{} rows, {} proved, 0 violated", rows, proved)))
      << made.err;
  EXPECT_THAT(made.out, HasSubstr("11534 measured without a guarantee"));
  timed("check", "{} check ar3d-rome.h5");
  timed("report", "{} report ar3d-rome.h5 -o rome.html");
  std::printf("page: %.1f MB, results: %.1f MB\n",
              static_cast<double>(fs::file_size(scratch_.path("rome.html"))) / 1e6,
              static_cast<double>(fs::file_size(scratch_.path("ar3d-rome.h5"))) / 1e6);
  EXPECT_LT(fs::file_size(scratch_.path("rome.html")), 10'000'000u);
  must("cd " + scratch_.path("") + " && {} study run -q rome.toml -o again.h5");
  expect_exit(0, timed("gate", "{} compare ar3d-rome.h5 again.h5 --drawings-only"));
}

}  // namespace
}  // namespace ar3d::testing
