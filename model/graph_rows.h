#pragma once

#include <cstdint>
#include <span>

#include "ar3d/model/graph.h"

namespace ar3d {

/// The compressed rows of a graph: row v is half_edges[offsets[v]..offsets[v + 1]), in the order of
/// the edges.
struct Rows {
  UnwrittenVector<std::uint32_t> offsets;  // n + 1
  UnwrittenVector<HalfEdge> half_edges;    // 2m
  std::uint32_t max_degree = 0;
};

/// The rows of m < 2^31 edges between n vertices (all ends are below n), on all threads
/// (threads_for). Cost: O(n + m) time; for each thread but the first 4n bytes while it runs.
Rows rows_of(std::uint64_t n, std::span<const Edge> edges);

}  // namespace ar3d
