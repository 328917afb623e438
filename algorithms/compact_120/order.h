#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/base/long_vector.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact_120 {

/// Which end of an edge is to the left: the one of smaller rank. Adjacent ranks differ.
struct Order {
  LongVector<std::uint32_t> rank;  ///< by vertex
  bool is_right(Vertex from, Vertex to) const { return rank[to] > rank[from]; }
};

/// Greedy colouring in order of vertex numbers in which vertices at distance 1 or 2 differ: colours
/// 0 .. 9 for maximum degree 3. O(n).
std::vector<std::uint8_t> distance_two_colours(const Graph& graph);

/// Steps D.1 to D.3: the order by colours, after the moves of sources and sinks. At most 76 ranks,
/// and by Lemma D.8 every component of the slot graph has at most one cycle. O(n).
Order moved_order(const Graph& graph);

/// The same order with ranks 0, 1, 2, ...: the length of the longest ascending path to a vertex.
/// O(n log n).
Order in_levels(const Graph& graph, const Order& order);

}  // namespace ar3d::compact_120
