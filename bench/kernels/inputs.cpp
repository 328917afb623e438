#include "inputs.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <tuple>

namespace ar3d::kernels {
namespace {

std::string written(const Graph& graph, const GraphFormat& format) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("ar3d-kernels-" + std::to_string(getpid()) + ".graph");
  write_graphs({graph}, format, path.string());
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  std::filesystem::remove(path);
  return content.str();
}

}  // namespace

const Graph& graph_of(const Family& family, std::uint64_t n) {
  static std::tuple<std::string, std::uint64_t> kept;
  static Graph graph;
  const std::tuple<std::string, std::uint64_t> wanted = {family.name, n};
  if (kept != wanted) graph = generate(family, n, kSeed);
  kept = wanted;
  return graph;
}

const std::string& text_of(const GraphFormat& format, const Family& family, std::uint64_t n) {
  static std::tuple<std::string, std::string, std::uint64_t> kept;
  static std::string text;
  const std::tuple<std::string, std::string, std::uint64_t> wanted = {format.name, family.name, n};
  if (kept != wanted) text = written(graph_of(family, n), format);
  kept = wanted;
  return text;
}

std::int64_t bytes_of_graph(const Graph& graph) {
  return 4 * (std::int64_t{graph.num_vertices()} + 1) + 24 * std::int64_t{graph.num_edges()};
}

}  // namespace ar3d::kernels
