#pragma once

#include <cstdint>
#include <span>

#include "ar3d/model/graph.h"

namespace ar3d {

/// Where the first neighbour that stands in the row before stands again; row.size() if none does.
/// All pairs are compared.
std::size_t first_repeat(std::span<const HalfEdge> row);

/// Rows up to this length are searched for parallel edges while they are built.
inline constexpr std::uint32_t kShortRow = 8;

/// The compressed rows of a graph: row v is half_edges[offsets[v]..offsets[v + 1]), in the order of
/// the edges.
struct Rows {
  UnwrittenVector<std::uint32_t> offsets;  // n + 1
  UnwrittenVector<HalfEdge> half_edges;    // 2m
  std::uint32_t max_degree = 0;
  std::uint64_t repeating = 0;  // the first short row that names a neighbour twice; n if none does
};

/// The rows of m < 2^31 edges between n vertices (all ends are below n), on all threads
/// (threads_for). Cost: O(n + m) time; while it runs n m / 2^30 bytes more than the rows, and for
/// each thread 8 bytes for each half-edge of the fullest 8192 vertices with neighbouring names.
Rows rows_of(std::uint64_t n, std::span<const Edge> edges);

}  // namespace ar3d
