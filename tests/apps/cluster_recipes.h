#pragma once

#include <unistd.h>

#include <string>

#include "support/program.h"

namespace ar3d::testing {

/// A code block of docs/cluster.md: what stands below "<!-- recipe: NAME -->".
inline std::string recipe(const std::string& name) {
  const std::string page = read_file(AR3D_SOURCE_DIR "/docs/cluster.md");
  const std::string mark = "<!-- recipe: " + name + " -->\n```sh\n";
  const std::size_t at = page.find(mark);
  if (at == std::string::npos) return "echo no recipe of that name >&2; exit 99";
  const std::size_t begin = at + mark.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

/// Puts the programs that were built into a folder `bin`, and that in front of PATH, as if they were
/// installed.
inline std::string with_programs(const ScratchDirectory& folder) {
  const std::string bin = folder.path("bin");
  if (fs::create_directory(bin)) {
    fs::create_symlink(AR3D_PROGRAM, bin + "/ar3d");
    fs::create_symlink(AR3D_MPI_PROGRAM, bin + "/ar3d-mpi");
  }
  return "export PATH=" + bin + ":$PATH; ";
}

/// What the page says to add as root.
inline std::string as_root() { return geteuid() == 0 ? recipe("mpi as root") : ""; }

/// Runs a recipe in a folder.
inline Outcome run_recipe(const ScratchDirectory& folder, const std::string& name) {
  return run(with_programs(folder) + "set -e; " + as_root() + "cd " + folder.path("") + "; " +
             recipe(name));
}

}  // namespace ar3d::testing
