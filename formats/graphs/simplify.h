#pragma once

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d {

/// Drops loops, and of parallel edges all but one; what stays is ordered by (u, v), u < v.
/// O(m log m).
inline void simplify(std::vector<Edge>& edges) {
  std::erase_if(edges, [](const Edge& edge) { return edge.u == edge.v; });
  for (Edge& edge : edges) {
    if (edge.u > edge.v) std::swap(edge.u, edge.v);
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return std::tie(a.u, a.v) < std::tie(b.u, b.v); });
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

}  // namespace ar3d
