#pragma once

#include <string>

#include "support/program.h"

namespace ar3d::testing {

/// A code block of docs/cluster.md: what stands below "<!-- recipe: NAME -->", with the path of the
/// program that was built instead of ./ar3d (the one for MPI behind mpirun), and mpirun willing to
/// run here.
inline std::string recipe(const std::string& name) {
  const std::string page = read_file(AR3D_SOURCE_DIR "/docs/cluster.md");
  const std::string mark = "<!-- recipe: " + name + " -->\n```sh\n";
  const std::size_t at = page.find(mark);
  if (at == std::string::npos) return "echo no recipe of that name >&2; exit 99";
  const std::size_t begin = at + mark.size();
  std::string text = page.substr(begin, page.find("```", begin) - begin);
  const auto replace = [&text](const std::string& from, const std::string& to) {
    for (std::size_t i = 0; (i = text.find(from, i)) != std::string::npos; i += to.size()) {
      text.replace(i, from.size(), to);
    }
  };
  replace("mpirun -n 4 ./ar3d", "mpirun -n 4 " AR3D_MPI_PROGRAM);
  replace("mpirun -n 2 ./ar3d", "mpirun -n 2 " AR3D_MPI_PROGRAM);
  replace("mpirun ./ar3d", "mpirun " AR3D_MPI_PROGRAM);
  replace("mpirun ", "mpirun --allow-run-as-root --oversubscribe ");
  replace("./ar3d", AR3D_PROGRAM);
  return text;
}

/// Runs a recipe in a folder.
inline Outcome run_recipe(const ScratchDirectory& folder, const std::string& name) {
  return run("set -e; cd " + folder.path("") + "; " + recipe(name));
}

}  // namespace ar3d::testing
