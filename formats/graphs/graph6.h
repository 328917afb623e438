#pragma once

#include <string>
#include <vector>

#include "ar3d/formats/graphs/graph_format.h"
#include "ar3d/formats/text/six_bits.h"

namespace ar3d {

/// What a line of text says before it is known to be a simple graph.
struct EdgesOnVertices {
  std::uint64_t n = 0;
  std::vector<Edge> edges;
};

/// Decodes the graph6 line at `bits`: N(n), then the upper triangle of the adjacency matrix column
/// by column. Edges come as (u, v) with u < v, ordered by (v, u).
/// @throws InputError on a wrong length, a wrong character or padding bits that are not zero.
/// Cost: O(line) time; memory for the edges only.
EdgesOnVertices decode_graph6(SixBits bits, const ReadOptions& options);

/// Appends the graph6 line of a graph with its newline. @throws InputError if n >= 2^18 (4 GiB a
/// line). Cost: O(n^2) time.
void append_graph6(std::string& out, const Graph& graph);

}  // namespace ar3d
