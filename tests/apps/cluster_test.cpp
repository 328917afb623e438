// The recipes of docs/cluster.md that need no cluster.
#include "apps/cluster_recipes.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

TEST(ClusterRecipe, Mpi) {
  const ScratchDirectory folder;
  expect_exit(0, run_recipe(folder, "mpi"));
  expect_exit(0, run_recipe(folder, "mpi resume"));
  expect_output(run_recipe(folder, "plan"), "on 12 threads");
  EXPECT_EQ(run("{} study run smoke -q -o " + folder.path("one.h5")).exit_code, 0);
  expect_same_rows(folder.path("smoke.h5"), folder.path("one.h5"));
}

TEST(ClusterRecipe, GnuParallel) {
  const ScratchDirectory folder;
  expect_exit(0, run_recipe(folder, "parallel"));
  EXPECT_EQ(run("{} study run smoke -q -o " + folder.path("one.h5")).exit_code, 0);
  expect_same_rows(folder.path("smoke.h5"), folder.path("one.h5"));
}

}  // namespace
}  // namespace ar3d::testing
