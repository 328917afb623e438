#include "ar3d/bench/compare/git.h"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <fstream>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/child_process.h"

namespace ar3d {

GitAnswer ask_git(std::vector<std::string> words) {
  namespace fs = std::filesystem;
  const fs::path log = fs::temp_directory_path() / fmt::format("ar3d-git-{}", getpid());
  words.insert(words.begin(), "git");
  GitAnswer answer;
  answer.exit_code = run_child(words, {.output = log.string()});
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) answer.lines.push_back(line);
  fs::remove(log);
  return answer;
}

std::string commit_of(const std::string& checkout, const std::string& ref) {
  const GitAnswer commit = ask_git(
      {"-C", checkout, "rev-parse", "--verify", "--quiet", "--end-of-options", ref + "^{commit}"});
  if (commit.exit_code != 0 || commit.lines.empty()) {
    throw InputError(fmt::format("no commit '{}' in {}", ref, checkout));
  }
  return commit.lines.front();
}

std::int64_t commits_up_to(const std::string& commit) {
  const GitAnswer count = ask_git({"rev-list", "--count", commit, "--"});
  std::int64_t number = -1;
  if (count.exit_code != 0 || count.lines.empty()) return -1;
  const std::string& text = count.lines.front();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? number : -1;
}

std::vector<Commit> commits_between(const std::string& checkout, const std::string& good,
                                    const std::string& bad) {
  const GitAnswer order = ask_git({"-C", checkout, "merge-base", "--is-ancestor", good, bad});
  if (order.exit_code != 0 || good == bad) {
    throw InputError(fmt::format("{} is no earlier commit than {}", good, bad));
  }
  const GitAnswer list = ask_git({"-C", checkout, "log", "--reverse", "--first-parent",
                                  "--format=%H %s", good + ".." + bad, "--"});
  std::vector<Commit> commits;
  for (const std::string& line : list.lines) {
    const std::size_t space = line.find(' ');
    commits.push_back({line.substr(0, space),
                       space == std::string::npos ? std::string() : line.substr(space + 1)});
  }
  if (list.exit_code != 0 || commits.empty() || commits.back().hash != bad) {
    throw InputError(fmt::format("git lists no commits from {} to {}", good, bad));
  }
  return commits;
}

}  // namespace ar3d
