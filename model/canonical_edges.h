#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d {

/// Sorts a few items, most of them in place already.
template <class Iterator, class Before>
void sort_row(Iterator begin, Iterator end, Before before) {
  if (end - begin > 16) return std::sort(begin, end, before);
  for (auto i = begin; i != end; ++i) {
    for (auto j = i; j != begin && before(*j, *std::prev(j)); --j) std::iter_swap(j, std::prev(j));
  }
}

/// True if every edge (u, v) has u < v and the edges ascend by (u, v), none standing twice.
/// O(m) time.
bool are_canonical(std::span<const Edge> edges);

/// Brings m < 2^32 edges without loops, with ends below n, into canonical order: every edge as
/// (u, v) with u < v, ascending by (u, v).
/// @return the smallest end of a pair that stands twice, in either order; n if there is none. If
/// there is one, the edges stay as they were.
/// Cost: O(n + m log D) time for the largest degree D, on all threads (threads_for), and while it
/// runs 8 m bytes, n m / 2^30 bytes and for each thread 8 bytes for each edge at the fullest 8192
/// vertices with neighbouring names.
std::uint64_t make_canonical(std::uint64_t n, std::vector<Edge>& edges);

/// Writes the adjacency lists of m < 2^31 edges in canonical order between n vertices, one behind
/// the other, on all threads (threads_for). That of v is half_edges[offsets[v] .. offsets[v + 1]),
/// ascending by neighbour and by edge.
/// @return the largest degree. Cost: O(n + m) time; while it runs n m / 2^30 bytes more than the
/// lists, and for each thread 8 bytes for each edge at the fullest 8192 vertices with neighbouring
/// names.
std::uint32_t make_adjacency_lists(std::uint64_t n, std::span<const Edge> edges,
                                   UnwrittenVector<std::uint32_t>& offsets,
                                   UnwrittenVector<HalfEdge>& half_edges);

}  // namespace ar3d
