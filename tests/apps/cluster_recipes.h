#pragma once

#include <unistd.h>

#include <regex>
#include <string>

#include "support/program.h"

namespace ar3d::testing {

/// A code block of docs/cluster.md: what stands below "<!-- recipe: NAME -->", with the path of the
/// program that was built instead of ./ar3d (the one for MPI behind mpirun).
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
  text = std::regex_replace(text, std::regex("(mpirun .*)\\./ar3d"), "$1" AR3D_MPI_PROGRAM);
  replace("./ar3d", AR3D_PROGRAM);
  return text;
}

/// Runs a recipe in a folder; as root with what the page says to add then.
inline Outcome run_recipe(const ScratchDirectory& folder, const std::string& name) {
  const std::string root = geteuid() == 0 ? recipe("mpi as root") : "";
  return run("set -e; " + root + "cd " + folder.path("") + "; " + recipe(name));
}

}  // namespace ar3d::testing
