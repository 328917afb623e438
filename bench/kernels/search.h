#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d::kernels {

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

}  // namespace ar3d::kernels
