// A study of a million rows from beginning to end, in little memory.
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/run_storage.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

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
  EXPECT_EQ(ResultsReader(results, run_format()).size(), 1000000u);
  const Outcome pandas =
      run("/usr/bin/python3 -c 'import pandas; "
          "print(len(pandas.read_hdf(\"" +
          results + "\", \"runs\", columns=[\"n\", \"log2_volume\", \"status\"])))'");
  EXPECT_EQ(pandas.out, "1000000\n") << pandas.err;
}

}  // namespace
}  // namespace ar3d::testing
