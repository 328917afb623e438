// The Slurm recipes of docs/cluster.md on a Slurm of one node, started for each and ended after it:
// one after the other, since two of them would have the same ports.
#include "apps/cluster_recipes.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

void run_on_slurm(const std::string& job_file, const std::string& name) {
  const ScratchDirectory folder;
  if (!job_file.empty()) folder.write(job_file, recipe(job_file));
  const std::string script =
      folder.write("script", with_programs(folder) + as_root() + "set -e\n" + recipe(name));
  expect_exit(
      0, run("cd " + folder.path("") +
             " && flock -o ${TMPDIR:-/tmp}/ar3d-one-node-slurm.lock timeout 300 " AR3D_SOURCE_DIR
             "/tests/cluster/one_node_slurm.sh slurm bash " +
             script + "; code=$?; cat slurm-*.out 2>&1; exit $code"));
  EXPECT_EQ(run("{} study run smoke -q -o " + folder.path("one.h5")).exit_code, 0);
  expect_same_rows(folder.path("smoke.h5"), folder.path("one.h5"));
  EXPECT_EQ(run("pgrep -f " + folder.path("slurm") + "[/.]").out, "") << "Slurm is torn down";
}

TEST(ClusterRecipe, SlurmArray) { run_on_slurm("array.sh", "slurm array"); }

TEST(ClusterRecipe, SlurmMpi) { run_on_slurm("ranks.sh", "slurm mpi"); }

TEST(ClusterRecipe, SlurmByHand) { run_on_slurm("", "srun"); }

}  // namespace
}  // namespace ar3d::testing
