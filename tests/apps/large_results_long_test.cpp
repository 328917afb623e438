// Verdict and report of a results file with very many rows, in little memory. AR3D_LARGE_ROWS sets
// how many; docs/study.md states what was measured with ten million.
#include <cstdlib>

#include "support/large_results.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

TEST(LargeResults, AreJudgedAndReportedInBoundedMemory) {
  const char* const wanted = std::getenv("AR3D_LARGE_ROWS");
  LargeResults like;
  like.rows = wanted == nullptr ? 1000000 : std::stoul(wanted);
  like.violated = 5;
  like.unfinished = 1000;
  const ScratchDirectory scratch;
  const std::string results = scratch.path("large.h5");
  write_large_results(like, results);
  // kB of address space, code included: 300 MB and 100 bytes per row.
  const std::string bounded = "ulimit -v " + std::to_string(300000 + like.rows / 10) + "; ";
  expect_output(run(bounded + "{} check " + results),
                "VIOLATED: " + std::to_string(like.rows) + " rows, " +
                    std::to_string(like.rows - 1005) +
                    " proved, 5 violated, 1000 incomplete, 0 refused",
                4);
  expect_exit(4, run(bounded + "{} report " + results + " -o " + scratch.path("page.html")));
  const auto bytes = fs::file_size(scratch.path("page.html"));
  EXPECT_LT(bytes, 8'000'000u);
  EXPECT_THAT(read_file(scratch.path("page.html")), HasSubstr("drawn at random"));
}

}  // namespace
}  // namespace ar3d::testing
