// A study of a file of a million graphs from beginning to end, in little memory.
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/run_storage.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

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
  EXPECT_EQ(ResultsReader(results, run_format()).size(), 1000000u);
}

}  // namespace
}  // namespace ar3d::testing
