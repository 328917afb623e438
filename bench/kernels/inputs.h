#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::kernels {

/// The seed of every random input of a kernel.
inline constexpr std::uint64_t kSeed = 1;

/// Random 4-regular graphs, or cubic ones for an algorithm that draws no degree 4.
inline const Family& random_family(const Algorithm& algorithm) {
  return find_family(algorithm.guarantee.max_degree == 4 ? "random-4-regular" : "random-cubic");
}

/// The family's graph with nearest_n(n) vertices in random order, made afresh.
inline Graph shuffled(const Family& family, std::uint64_t n) {
  return generate(family, n, kSeed, {{"shuffle", 1}});
}

/// The family's graph with nearest_n(n) vertices. The last one is kept, so that kernels that follow
/// each other share it; the reference is good until the next call.
const Graph& graph_of(const Family& family, std::uint64_t n);

/// The same graph as a file of the format, kept likewise.
const std::string& text_of(const GraphFormat& format, const Family& family, std::uint64_t n);

/// Bytes that the graph takes in memory (model/graph.h).
std::int64_t bytes_of_graph(const Graph& graph);

/// All vertices in the order of a plain breadth-first search of all components: the yardstick of
/// drawing times.
inline std::vector<Vertex> search_breadth_first(const Graph& graph) {
  std::vector<std::uint8_t> seen(graph.num_vertices(), 0);
  std::vector<Vertex> queue;
  for (Vertex start = 0; start < graph.num_vertices(); ++start) {
    if (seen[start]) continue;
    seen[start] = 1;
    std::size_t head = queue.size();
    queue.push_back(start);
    while (head < queue.size()) {
      for (const HalfEdge& half : graph.incident(queue[head++])) {
        if (seen[half.to]) continue;
        seen[half.to] = 1;
        queue.push_back(half.to);
      }
    }
  }
  return queue;
}

/// Registers the kernels of all catalogue rows. To be called from main(): the catalogues themselves
/// need initialised constants.
void register_catalogues();

}  // namespace ar3d::kernels
