// Graphs and texts that kernels share.
#include "inputs.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <tuple>

namespace ar3d::kernels {
namespace {

constexpr std::int64_t kMostBytes = std::int64_t{1} << 31;

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
  static std::mutex mutex;
  static std::map<std::tuple<std::string, std::uint64_t>, Graph> kept;
  static std::int64_t bytes = 0;
  const std::lock_guard lock(mutex);
  if (const auto found = kept.find({family.name, n}); found != kept.end()) return found->second;
  if (bytes >= kMostBytes) {
    kept.clear();
    bytes = 0;
  }
  Graph graph = generate(family, n, kSeed, {{"shuffle", 1}});
  bytes += bytes_of_graph(graph);
  return kept.emplace(std::tuple(family.name, n), std::move(graph)).first->second;
}

const std::string& text_of(const GraphFormat& format, const Family& family, std::uint64_t n) {
  static std::tuple<std::string, std::string, std::uint64_t> kept;
  static std::string text;
  const std::tuple<std::string, std::string, std::uint64_t> wanted = {format.name, family.name, n};
  if (kept != wanted) text = written(generate(family, n, kSeed), format);
  kept = wanted;
  return text;
}

std::int64_t bytes_of_graph(const Graph& graph) {
  return 4 * (std::int64_t{graph.num_vertices()} + 1) + 24 * std::int64_t{graph.num_edges()};
}

}  // namespace ar3d::kernels
