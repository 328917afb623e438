#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::kernels {

/// Holds the seed of every random input of a kernel.
inline constexpr std::uint64_t kSeed = 1;

/// Returns random 4-regular graphs, or cubic ones for an algorithm that draws no degree 4.
inline const Family& random_family(const Algorithm& algorithm) {
  return find_family(algorithm.guarantee.max_degree == 4 ? "random-4-regular" : "random-cubic");
}

/// Returns the family's graph with nearest_n(n) vertices in random order. Graphs are kept, since
/// kernels take turns, until there are two gigabytes of them: the reference is good until the next
/// call for another graph. Several threads may ask for the same graph.
const Graph& graph_of(const Family& family, std::uint64_t n);

/// Returns the graph as a file of the format, vertices in the generator's order; the last one is
/// kept.
const std::string& text_of(const GraphFormat& format, const Family& family, std::uint64_t n);

/// Returns the bytes that the graph takes in memory (model/graph.h).
std::int64_t bytes_of_graph(const Graph& graph);

/// Returns all vertices in the order of a plain breadth-first search of all components: the
/// yardstick of drawing times.
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

// Each program of kernels defines these two; main.cpp calls them.

/// Registers the kernels that loop over catalogues. To be called from main(): the catalogues
/// themselves need initialised constants.
void register_catalogues();

/// Returns the arguments of Google Benchmark that hold where the user gives no others.
std::span<const char* const> default_arguments();

}  // namespace ar3d::kernels
