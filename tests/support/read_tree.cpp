// What references.h judges: the tree's files and the program's help.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

#include "support/program.h"
#include "support/references.h"

namespace ar3d::testing {

namespace fs = std::filesystem;

Tree read_tree(const std::string& root) {
  static const std::set<std::string> binary = {".h5", ".csv", ".gz", ".xz", ".png", ".pdf"};
  Tree tree;
  for (fs::recursive_directory_iterator at(root), end; at != end; ++at) {
    const std::string name = at->path().filename();
    if (at->is_directory() && (name.starts_with(".") || name.starts_with("build") ||
                               name == "_skbuild" || name == "node_modules")) {
      at.disable_recursion_pending();
    } else if (at->is_regular_file()) {
      const std::string path = fs::relative(at->path(), root).generic_string();
      tree.files[path] = binary.contains(at->path().extension()) ? "" : read_file(at->path());
    }
  }
  return tree;
}

void expect_of_sources(const char* pattern, int least,
                       const std::function<std::string(const std::string& text)>& lacks) {
  const std::regex whole(pattern);
  int sources = 0;
  for (const auto& [path, text] : read_tree(AR3D_SOURCE_DIR).files) {
    if (!std::regex_match(path, whole)) continue;
    ++sources;
    EXPECT_EQ(lacks(text), "") << path;
  }
  EXPECT_GT(sources, least);
}

std::map<std::string, std::string> read_help() {
  std::map<std::string, std::string> help;
  const std::function<void(const std::string&)> ask = [&](const std::string& verb) {
    const std::string text = run("{} " + verb + " --help").out;
    help[verb] = text;
    std::istringstream lines(text.substr(std::min(text.size(), text.find("Subcommands:"))));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && line.starts_with("  ")) {
      std::istringstream words(line);
      std::string name;
      words >> name;
      if (line[2] != ' ') ask(verb.empty() ? name : std::string(verb).append(" ").append(name));
    }
  };
  ask("");
  return help;
}

}  // namespace ar3d::testing
