#include "ar3d/bench/compare/reference_build.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "ar3d/bench/measure/child_process.h"
#include "ar3d/model/error.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

struct Said {
  int exit_code = 0;
  std::string first_line;
};

Said ask_git(std::vector<std::string> words) {
  const fs::path log = fs::temp_directory_path() / fmt::format("ar3d-git-{}", getpid());
  words.insert(words.begin(), "git");
  Said said;
  said.exit_code = run_child(words, {.output = log.string()});
  std::ifstream file(log);
  std::getline(file, said.first_line);
  fs::remove(log);
  return said;
}

void run_or_throw(const std::vector<std::string>& words, const std::string& folder,
                  const fs::path& log, const std::string& what) {
  const int code = run_child(words, {.folder = folder, .output = log.string()});
  if (code != 0) {
    throw InputError(fmt::format("cannot {}: {} ended with code {}, see {}", what, words[0], code,
                                 log.string()));
  }
}

}  // namespace

std::string find_checkout() {
  const Said root = ask_git({"rev-parse", "--show-toplevel"});
  if (root.exit_code != 0 || !fs::exists(fs::path(root.first_line) / "apps" / "study.cpp")) {
    throw InputError("the working directory is in no git checkout of ar3d");
  }
  return root.first_line;
}

std::string build_reference(const std::string& checkout, const std::string& ref,
                            std::FILE* progress) {
  const Said commit = ask_git(
      {"-C", checkout, "rev-parse", "--verify", "--quiet", "--end-of-options", ref + "^{commit}"});
  if (commit.exit_code != 0) throw InputError(fmt::format("no commit '{}' in {}", ref, checkout));
  const fs::path folder = fs::path(checkout) / "build" / "compare";
  const fs::path sources = folder / commit.first_line, build = sources / "build" / "compare";
  const fs::path log = folder / (commit.first_line + ".log");
  const std::string what = fmt::format("build {}", ref);
  fs::create_directories(folder);
  if (!fs::exists(sources / ".git")) {
    run_or_throw({"git", "-C", checkout, "worktree", "prune"}, "", log, what);
    run_or_throw(
        {"git", "-C", checkout, "worktree", "add", "--detach", sources.string(), commit.first_line},
        "", log, what);
  }
  const fs::path program = build / "apps" / "ar3d";
  if (progress != nullptr && !fs::exists(program)) {
    fmt::print(progress, "building {} in {}, which takes minutes\n", ref, build.string());
  }
  run_or_throw({"cmake", "-S", sources.string(), "-B", build.string(), "-G", "Ninja",
                "-DCMAKE_BUILD_TYPE=Release", "-DAR3D_TESTS=OFF", "-DAR3D_BENCHMARKS=OFF"},
               "", log, what);
  run_or_throw({"ninja", "-C", build.string(), "ar3d_program"}, "", log, what);
  return program.string();
}

}  // namespace ar3d
