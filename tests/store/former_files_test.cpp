// Results files of version 2, which have no checksum.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include "ar3d/store/run_storage.h"
#include "support/program.h"

namespace ar3d {
namespace {

// True if every session says that nobody could have noticed a changed value.
bool has_no_checksum(const Results& results) {
  std::set<std::int64_t> sessions;
  std::set<std::int64_t> marked;
  for (const EnvironmentEntry& entry : results.environment) {
    sessions.insert(entry.session);
    if (entry.name == "checksum" && entry.value == "none: the rows are of a file of version 2") {
      marked.insert(entry.session);
    }
  }
  return !sessions.empty() && marked == sessions;
}

// The committed files of version 2: every column that both versions have has the same values.
TEST(FormerResultsFiles, AreRead) {
  const testing::ScratchDirectory scratch;
  for (const char* name : {"compact-volume", "grid-million", "two-bend-million", "volume"}) {
    const std::string path =
        std::string(AR3D_SOURCE_DIR "/results/reference/0.1.0-") + name + ".h5";
    const Results results = read_results(path);
    ASSERT_FALSE(results.runs.empty()) << path;
    EXPECT_EQ(results.spec_hash, content_hash(results.spec));
    for (const ar3d::RunRecord& run : results.runs) {
      EXPECT_GT(run.requested_n, 0);
      if (run.status != RunStatus::ok) continue;
      EXPECT_GT(run.theorem_bound[0], 0) << run.algorithm;
      EXPECT_FALSE(std::isnan(run.log2_volume));
    }
    write_results(results, scratch.path("now.h5"));
    for (const Results& rows : {results, read_results(scratch.path("now.h5"))}) {
      EXPECT_TRUE(has_no_checksum(rows)) << path;
    }
    std::ofstream(scratch.path("same.py")) << R"(
import sys, h5py, numpy
old, new = (h5py.File(f)["runs"][:] for f in sys.argv[1:])
new_name = {"wanted_n": "requested_n", "timing_mark": "build_kind"}
common = [n for n in old.dtype.names if new_name.get(n, n) in new.dtype.names]
assert len(common) > 50, common
for n in common:
    assert old[n].tobytes() == new[new_name.get(n, n)].tobytes(), n
a = h5py.File(sys.argv[2])["algorithms"][:]
for r in a:
    rows = old[(old["algorithm"] == r["algorithm"]) & (old["options"] == r["options"])]
    rows = rows[rows["status"] == b"ok"]
    for axis in "xyz":
        bound = (r["theorem_numerator_" + axis] / r["theorem_denominator_" + axis]
                 * rows["n"] ** r["theorem_exponent_" + axis] + r["theorem_constant_" + axis])
        assert numpy.allclose(bound, rows["theorem_bound_" + axis], rtol=1e-12), (r, axis)
)";
    EXPECT_EQ(std::system(("/usr/bin/python3 " + scratch.path("same.py") + " " + path + " " +
                           scratch.path("now.h5"))
                              .c_str()),
              0)
        << name;
  }
}

}  // namespace
}  // namespace ar3d
