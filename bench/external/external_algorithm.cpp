#include "ar3d/bench/external/external_algorithm.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"
#include "ar3d/formats/graphs/graph6.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/model/settings.h"

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

}  // namespace ar3d
