#pragma once

#include <cstdint>
#include <span>

#include "ar3d/model/graph.h"

namespace ar3d {

/// The adjacency lists of a graph, one behind the other: that of v is half_edges[offsets[v] ..
/// offsets[v + 1]), ascending by neighbour and by edge.
struct AdjacencyLists {
  UnwrittenVector<std::uint32_t> offsets;  // n + 1
  UnwrittenVector<HalfEdge> half_edges;    // 2m
  std::uint32_t max_degree = 0;
};

/// The lists of m < 2^31 edges in canonical order (model/canonical_edges.h) between n vertices, on
/// all threads (threads_for). Cost: O(n + m) time; while it runs n m / 2^30 bytes more than the
/// lists, and for each thread 8 bytes for each edge at the fullest 8192 vertices with neighbouring
/// names.
AdjacencyLists adjacency_lists(std::uint64_t n, std::span<const Edge> edges);

}  // namespace ar3d
