#pragma once

// What the tests of the graph formats share: reading from text, refusals, comparing graphs as edge
// sets.

#include <unistd.h>

#include <algorithm>
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

/// Expects that each text is refused with that message.
inline void expect_refusals(const std::vector<std::pair<std::string, std::string>>& cases,
                            const ReadOptions& options = {}) {
  for (const auto& [text, message] : cases) EXPECT_EQ(refusal(text, options), message) << text;
}

inline std::string written(const std::vector<Graph>& graphs, const GraphFormat& format,
                           unsigned base = 0) {
  const ScratchDirectory folder = ScratchDirectory::in_memory();
  write_graphs(graphs, format, folder.path("graph"), base);
  return read_file(folder.path("graph"));
}

/// n and the edges as a sorted list of pairs (smaller, larger): equal for equal labelled graphs.
inline std::pair<Vertex, std::vector<std::pair<Vertex, Vertex>>> edge_set(const Graph& graph) {
  std::vector<std::pair<Vertex, Vertex>> edges;
  for (const Edge e : graph.edges()) edges.emplace_back(std::min(e.u, e.v), std::max(e.u, e.v));
  std::sort(edges.begin(), edges.end());
  return {graph.num_vertices(), edges};
}

}  // namespace ar3d::testing
