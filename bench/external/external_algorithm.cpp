// Describes a program that draws graphs: its command line, the line that it reads for a graph, and
// the hash and version under which its results are kept.
#include "ar3d/bench/external/external_algorithm.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/formats/graphs/graph6.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/store/columns/study_identity.h"

namespace ar3d {
namespace {

std::string with_values(const std::string& word, const ExternalAlgorithm& algorithm,
                        const Settings& options) {
  std::string text;
  for (std::size_t at = 0; at < word.size();) {
    if (word[at] != '{') {
      text += word[at++];
      continue;
    }
    const std::size_t end = word.find('}', at);
    const std::string name = end == std::string::npos ? "" : word.substr(at + 1, end - at - 1);
    const auto option = std::find_if(options.begin(), options.end(),
                                     [&](const Setting& setting) { return setting.name == name; });
    if (option == options.end()) {
      throw InputError(fmt::format("command of {}: '{}' names no option of it in braces",
                                   algorithm.row.name, word));
    }
    text += std::to_string(option->value);
    at = end + 1;
  }
  return text;
}

std::string edge_list(const Graph& graph) {
  std::string text;
  text.reserve(16 * (std::size_t{1} + graph.num_edges()));
  const auto append_line = [&text](std::uint64_t a, std::uint64_t b) {
    append_all(text, a, ' ', b, '\n');
  };
  append_line(graph.num_vertices(), graph.num_edges());
  for (const auto [u, v] : graph.edges()) append_line(u, v);
  return text;
}

namespace fs = std::filesystem;

/// The hash of a regular file's bytes; nothing if it is none or cannot be read.
std::optional<std::string> hash_of_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error) || error) return {};
  std::ifstream file(path, std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  if (!file) return {};
  return content_hash(bytes.str());
}

/// As execvp looks it up.
std::optional<std::string> hash_of_executable(const std::string& name) {
  if (name.find('/') != std::string::npos) return hash_of_file(name);
  const char* variable = std::getenv("PATH");
  std::istringstream folders(variable == nullptr ? "/bin:/usr/bin" : variable);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (auto hash = hash_of_file(fs::path(folder) / name)) return hash;
  }
  return {};
}

}  // namespace

std::vector<std::string> command_with(const ExternalAlgorithm& algorithm, const Settings& options) {
  std::vector<std::string> words;
  for (const std::string& word : algorithm.command) {
    words.push_back(with_values(word, algorithm, options));
  }
  return words;
}

std::string request_of(const ExternalAlgorithm& algorithm, const Graph& graph) {
  if (algorithm.input == "edgelist") return edge_list(graph);
  std::string text;
  if (algorithm.input == "graph6") {
    append_graph6(text, graph);
  } else {
    append_sparse6(text, graph);
  }
  return text;
}

std::string program_hash(const ExternalAlgorithm& program) {
  const std::optional<std::string> executable = hash_of_executable(program.command.front());
  if (!executable) return kAbsentProgram;
  std::string all = *executable;
  for (std::size_t i = 1; i < program.command.size(); ++i) {
    if (const auto hash = hash_of_file(program.command[i])) all += " " + *hash;
  }
  return content_hash(all);
}

std::string program_version(const ExternalAlgorithm& program) {
  if (!program.version.empty()) return program.version;
  fs::path file;
  for (const std::string& word : program.command) {
    std::error_code error;
    const bool is_path = &word != &program.command.front() || word.find('/') != std::string::npos;
    if (is_path && fs::is_regular_file(word, error)) file = word;
  }
  if (file.empty()) return "";
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  const std::vector<std::string> commit =
      ask_git({"-C", folder, "describe", "--always", "--abbrev=40", "--dirty", "--exclude=*"});
  return commit.size() == 1 ? commit.front() : "";
}

}  // namespace ar3d
