#pragma once

// What the tests of the graph formats share: reading from text, refusals, comparing graphs as edge
// sets.

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/formats/catalog.h"
#include "support/problem.h"
#include "support/program.h"

namespace ar3d::testing {

inline std::vector<Graph> read_text(const std::string& text, const ReadOptions& options = {}) {
  GraphReader reader(TextInput("f", bytes_of(text)), options);
  std::vector<Graph> graphs;
  while (std::optional<Graph> graph = reader.next()) graphs.push_back(std::move(*graph));
  return graphs;
}

/// The message that refuses the text, "accepted" if it does not.
inline std::string refusal(const std::string& text, const ReadOptions& options = {}) {
  return problem([&] { read_text(text, options); }, "accepted");
}

/// A folder for the test's files, removed with them; in memory where the system has such a place,
/// since every committed file is synchronised.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const fs::path memory = "/dev/shm";
    const bool usable = ::access(memory.c_str(), W_OK) == 0;
    const auto parent = usable ? memory : fs::temp_directory_path();
    std::string name = (parent / "ar3d-test-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { fs::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

 private:
  fs::path path_;
};

inline void write_file(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string written(const std::vector<Graph>& graphs, const GraphFormat& format,
                           const WriteOptions& options = {}) {
  const TemporaryFolder folder;
  write_graphs(graphs, format, folder.file("graph"), options);
  return read_file(folder.file("graph"));
}

/// n and the edges as a sorted list of pairs (smaller, larger): equal for equal labelled graphs.
inline std::pair<Vertex, std::vector<std::pair<Vertex, Vertex>>> edge_set(const Graph& graph) {
  std::vector<std::pair<Vertex, Vertex>> edges;
  for (const Edge e : graph.edges()) edges.emplace_back(std::min(e.u, e.v), std::max(e.u, e.v));
  std::sort(edges.begin(), edges.end());
  return {graph.num_vertices(), edges};
}

}  // namespace ar3d::testing
