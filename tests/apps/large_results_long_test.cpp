// A million graphs, a million rows, and results larger than the memory.
#include <cstdlib>

#include "ar3d/store/rows.h"
#include "support/large_results.h"
#include "support/program.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

// Verdict and report of a results file with very many rows, in little memory. AR3D_LARGE_ROWS sets
// how many; docs/study.md states what was measured with ten million.

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
  EXPECT_GT(tables_in(read_file(scratch.path("page.html")))["study"][0]["kept_graphs"], 0);
}

// A study of a file of a million graphs from beginning to end, in little memory.

TEST(MillionGraphs, RunAndResumeInBoundedMemory) {
  const ScratchDirectory scratch;
  const std::string graphs = scratch.path("million.s6.gz");
  must("{} generate random-subcubic -n 12 --count 1000000 | gzip -1 > " + graphs);
  const std::string results = scratch.path("m.h5");
  const std::string bounded = "ulimit -v 800000; ";  // kB of address space, code included
  // Stopped in the midst of it, however fast the machine is.
  const Outcome cut =
      run(bounded + "{} study run -q --threads 2 --graphs " + graphs + " --algorithm diamond -o " +
          results + " & p=$!; while kill -0 $p && [ $(stat -c %s " + results +
          ".journal || echo 0) -lt 30000000 ]; do sleep 0.1; done 2>/dev/null; "
          "kill -TERM $p; wait $p; {} study status " +
          results);
  EXPECT_THAT(cut.out, HasSubstr(" of 1000000 rows")) << cut.err;
  expect_output(run(bounded + "{} study resume -q --threads 2 " + results),
                "PASS: 1000000 rows, 1000000 proved");
  EXPECT_EQ(Rows(results).size(), 1000000u);
}

// A study of a million rows from beginning to end, in little memory.

const char* const kMillion = R"(study = "million-rows"
[[sweep]]
families = "random-cubic"
sizes = 10
algorithms = "grid"
instances = 1000000
)";

TEST(MillionRows, RunResumeStatusAndPandas) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("m.toml", kMillion);
  const std::string results = scratch.path("m.h5");
  const std::string bounded = "ulimit -v 800000; ";  // kB of address space, code included
  const Outcome cut = run(bounded + "timeout -s INT 20 {} study run -q --threads 2 " + spec +
                          " -o " + results + "; {} study status " + results);
  EXPECT_THAT(cut.out, HasSubstr(" of 1000000 rows")) << cut.err;
  expect_output(run(bounded + "{} study resume -q --threads 2 " + results),
                {"PASS: 1000000 rows, 1000000 proved", "report   "});
  EXPECT_LT(fs::file_size(scratch.path("m.html")), 1'000'000u);
  EXPECT_FALSE(fs::exists(results + ".journal"));
  EXPECT_EQ(Rows(results).size(), 1000000u);
  const Outcome pandas =
      run("/usr/bin/python3 -c 'import pandas; "
          "print(len(pandas.read_hdf(\"" +
          results + "\", \"runs\", columns=[\"n\", \"log2_volume\", \"status\"])))'");
  EXPECT_EQ(pandas.out, "1000000\n") << pandas.err;
}

}  // namespace
}  // namespace ar3d::testing
