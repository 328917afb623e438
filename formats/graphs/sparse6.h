#pragma once

#include <functional>
#include <string>

#include "ar3d/formats/graphs/graph6.h"

namespace ar3d {

/// Decodes the sparse6 line at `bits` (behind its ':'): N(n), then pairs (b, x) of 1 and k bits, k
/// the number of bits of n - 1; b moves the current vertex v on by one, then x > v moves it to x
/// and x <= v is an edge. Edges come as (x, v) in the line's order (for most writers ordered by (v,
/// x)).
/// @throws InputError on a wrong character, a loop unless options.simplify, or padding that is not
/// the format's. Cost: O(line) time; memory for the edges only.
EdgesOnVertices decode_sparse6(SixBits bits, const ReadOptions& options);

/// Decodes the incremental sparse6 line at `bits` (behind its ';'): the pairs of the edges in which
/// the graph differs from the previous one. Edges come as (x, v) ordered by (v, x).
/// @throws InputError as decode_sparse6, and on an edge given twice.
EdgesOnVertices decode_incremental_sparse6(SixBits bits, std::uint64_t n,
                                           const std::vector<Edge>& previous);

/// Appends the sparse6 line of a graph with its newline. O(n + m) time.
/// @param pass_on  called now and then; may take the text away, so that no long line is held.
void append_sparse6(
    std::string& out, const Graph& graph, const std::function<void()>& pass_on = [] {});

/// Appends the line that turns `previous` into `graph` (both on the same number of vertices).
/// O(m log m) time.
void append_incremental_sparse6(std::string& out, const Graph& previous, const Graph& graph);

}  // namespace ar3d
