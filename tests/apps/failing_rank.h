#pragma once

#include <fmt/format.h>

#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {

/// Runs `smoke` on two ranks of which one's `call`-th call on a file of the study fails. Expects
/// that the ranks have ended within a minute with a message, unless the study could do without that
/// call, and that what is left is resumed to the rows of `whole`.
/// @return whether there was such a call.
inline bool expect_failure_ends_all(const ScratchDirectory& scratch, const std::string& whole,
                                    int rank, int call) {
  fs::remove_all(scratch.path("study"));
  fs::create_directory(scratch.path("study"));
  const std::string results = scratch.path("study/r.h5");
  const std::string plain = fmt::format("{} study run smoke -q -o {}", AR3D_MPI_PROGRAM, results);
  const std::string failing =
      fmt::format("{}AR3D_FAULT_IN={} {}", with_fault(fmt::format("errno:{}", call)),
                  scratch.path("study"), plain);
  const Outcome ended =
      run(fmt::format("timeout 60 mpirun --allow-run-as-root --oversubscribe -n 1 {} : -n 1 {}",
                      rank == 0 ? failing : plain, rank == 0 ? plain : failing));
  if (ended.exit_code == 0) {
    expect_same_rows(results, whole);
    return ended.err.find("fault of call") != std::string::npos;
  }
  EXPECT_NE(ended.exit_code, 124) << "rank " << rank << ", call " << call << ": hangs";
  EXPECT_THAT(ended.err, HasSubstr("ar3d: ")) << "rank " << rank << ", call " << call;
  const bool begun = fs::exists(results) || fs::exists(results + ".journal") ||
                     fs::exists(results + ".rank-1.journal");
  expect_exit(0,
              run(begun ? "{} study resume -q " + results : "{} study run smoke -q -o " + results));
  expect_same_rows(results, whole);
  return true;
}

}  // namespace ar3d::testing
