// Builds the program of another commit in a worktree beside the checkout. The finished program is
// put in place whole, so that an interrupted build leaves nothing that a later one would take.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/scope_exit.hpp>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/print.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/compare/interleave.h"
#include "ar3d/bench/measure/processes.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

/// The 40 digits of a commit. @throws InputError naming the ref if there is no such commit.
std::string commit_of(const std::string& checkout, const std::string& ref) {
  const std::vector<std::string> commit = ask_git(
      {"-C", checkout, "rev-parse", "--verify", "--quiet", "--end-of-options", ref + "^{commit}"});
  if (commit.empty()) throw InputError(fmt::format("no commit '{}' in {}", ref, checkout));
  return commit.front();
}

/// "[57/140] Building …" of ninja's last line, as "57 of 140"; empty if there is none.
std::string steps_done(const fs::path& log) {
  std::ifstream file(log);
  std::string steps;
  for (std::string line; std::getline(file, line);) {
    const std::size_t slash = line.find('/'), end = line.find(']');
    if (!line.starts_with('[') || end == std::string::npos || slash > end) continue;
    steps = line.substr(1, slash - 1) + " of " + line.substr(slash + 1, end - slash - 1);
  }
  return steps;
}

/// Runs a step of a build. @return false if a signal asked to stop. @throws InputError naming the
/// log if it fails.
bool run_step(const std::vector<std::string>& words, const std::string& ref, const fs::path& log,
              std::FILE* progress) {
  constexpr int kSecondsBetweenLines = 5;
  std::string last;
  int seconds = 0;
  const auto tell = [&] {
    if (progress == nullptr || ++seconds % kSecondsBetweenLines != 0) return;
    const std::string steps = steps_done(log);
    if (steps.empty() || steps == last) return;
    print(progress, "building {}: step {}\n", ref, steps);
    last = steps;
  };
  const int code = run_child(
      words, {.output = log.string(), .ends_when_interrupted = true, .every_second = tell});
  if (is_interrupted()) return false;
  if (code == 0) return true;
  throw InputError(fmt::format("cannot build {}: {} ended with code {}, see {}", ref, words[0],
                               code, log.string()));
}

constexpr std::string_view kSources = ".sources-";

/// The folder, locked for as long as the descriptor is open; none if another process has locked it.
Descriptor locked_folder(const fs::path& folder) {
  Descriptor locked(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return flock(locked.get(), LOCK_EX | LOCK_NB) == 0 ? std::move(locked) : Descriptor();
}

/// Removes the worktrees that killed programs have left in a folder.
void remove_worktrees(const std::string& checkout, const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const bool is_sources = entry.path().filename().string().find(kSources) != std::string::npos;
    if (!is_sources || locked_folder(entry.path()).get() < 0) continue;
    ask_git({"-C", checkout, "worktree", "unlock", entry.path().string()});  // half made
    remove_folder(entry.path());
  }
}

/// Copies a program: the copy is on the disk whole under its name, or not at all.
void copy_program(const fs::path& from, const fs::path& to) {
  const std::string bytes = read_file(from.string());
  if (bytes.empty()) throw InputError(fmt::format("{} is empty", from.string()));
  NewFile copy(to.string());
  copy.write_all(bytes);
  const auto mode = static_cast<mode_t>(fs::status(from).permissions());
  if (fchmod(copy.descriptor(), mode) != 0) refuse_writing(to.string(), errno);
  copy.become_target();
}

/// Builds the commit and puts its program in place, whole or not at all.
/// @param run  runs a step; false: it was interrupted. @return the same.
bool build_program(const std::string& checkout, const std::string& commit, const fs::path& program,
                   const std::function<bool(const std::vector<std::string>&)>& run) {
  const fs::path folder = program.parent_path();
  const std::string sources = fmt::format("{}{}{}", folder.string(), kSources, getpid());
  const std::string tree = sources + "/build/compare";
  remove_worktrees(checkout, folder.parent_path());
  fs::create_directories(sources);
  const Descriptor lock = locked_folder(sources);
  BOOST_SCOPE_EXIT_ALL(&) {
    remove_folder(sources);
    ask_git({"-C", checkout, "worktree", "prune"});
  };
  const bool is_built =
      run({"git", "-C", checkout, "worktree", "add", "--detach", sources, commit}) &&
      run({"cmake", "-S", sources, "-B", tree, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
           "-DAR3D_TESTS=OFF", "-DAR3D_BENCHMARKS=OFF"}) &&
      run({"ninja", "-C", tree, "ar3d_program"});
  if (!is_built) return false;
  fs::create_directories(folder);
  copy_program(fs::path(tree) / "apps" / "ar3d", program);
  return true;
}

}  // namespace

std::string last_line(const fs::path& log) {
  std::ifstream file(log);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

std::string checkout_here() {
  const std::vector<std::string> root = ask_git({"rev-parse", "--show-toplevel"});
  const bool is_ours = !root.empty() && fs::exists(fs::path(root.front()) / "apps" / "study.cpp");
  return is_ours ? root.front() : std::string();
}

std::string find_checkout() {
  std::string checkout = checkout_here();
  if (checkout.empty()) throw InputError("the working directory is in no git checkout of ar3d");
  return checkout;
}

std::optional<std::string> build_reference(const std::string& checkout, const std::string& ref,
                                           std::FILE* progress) {
  const std::string commit = commit_of(checkout, ref);
  const fs::path folder = fs::path(checkout) / "build" / "compare";
  const fs::path program = folder / commit / "ar3d";
  if (fs::exists(program)) return program.string();
  fs::create_directories(folder);
  const fs::path log = folder / (commit + ".log");
  if (progress != nullptr) {
    print(progress, "building {} as {}, which takes minutes\n", ref, program.string());
  }
  const bool is_built = build_program(
      checkout, commit, program,
      [&](const std::vector<std::string>& words) { return run_step(words, ref, log, progress); });
  fs::remove(log);
  return is_built ? std::optional(program.string()) : std::nullopt;
}

std::optional<std::string> build_own(const std::string& ref, const std::string& command,
                                     const std::string& folder) {
  const std::vector<std::string> root = ask_git({"rev-parse", "--show-toplevel", "--show-prefix"});
  if (root.empty()) throw InputError("the working directory is in no git repository");
  const std::string commit = commit_of(root.front(), ref), log = folder + ".log";
  const std::string inside = root.size() > 1 ? (fs::path(folder) / root[1]).string() : folder;
  const std::vector<std::vector<std::string>> steps = {
      {"git", "clone", "-q", "--shared", "--no-checkout", root.front(), folder},
      {"git", "-C", folder, "checkout", "-q", "--detach", commit},
      {"env", "-C", inside, "sh", "-c", command}};
  for (const std::vector<std::string>& words : steps) {
    const int code = run_child(words, {.output = log, .ends_when_interrupted = true});
    if (is_interrupted()) return {};
    if (code == 0) continue;
    throw InputError(fmt::format("cannot build {}: `{}` ended with code {}: {}", ref,
                                 words[0] == "env" ? command : words[0], code,
                                 printable(last_line(log))));
  }
  return inside;
}

}  // namespace ar3d
