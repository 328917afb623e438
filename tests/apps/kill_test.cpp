
#include "support/killed_studies.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

TEST(KilledStudies, LoseNothing) { kill_and_resume(25, 1); }

// The disk fills up at some point of the study, be it in the journal or in the results file.
TEST(FullDisk, IsResumedWhereverItStrikes) {
  const ScratchDirectory scratch;
  must("{} study run smoke -q -o " + scratch.path("whole.h5"));
  for (const char* room : {"1000", "20000", "60000", "330000"}) {
    const std::string results = scratch.path(std::string(room) + ".h5");
    const std::string limited = std::string("ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD=") +
                                AR3D_FAULT_SHIM + " AR3D_FAULT=full:" + room + " {} study ";
    const Outcome full = run(limited + "run smoke -q -o " + results);
    EXPECT_EQ(full.exit_code, std::string(room) == "1000" ? 2 : 5) << "2: before any work";
    EXPECT_THAT(full.err, HasSubstr("No space left on device")) << room;
    const bool begun = fs::exists(results + ".journal");
    expect_exit(
        0, run(begun ? "{} study resume -q " + results : "{} study run smoke -q -o " + results));
    expect_same_rows(results, scratch.path("whole.h5"));
  }
}

}  // namespace
}  // namespace ar3d::testing
