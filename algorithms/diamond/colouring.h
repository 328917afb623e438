#pragma once

// Step 1.1: the edges in two colours such that every vertex has at most two edges of each
// colour.

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "ar3d/model/graph.h"

namespace ar3d::diamond {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The neighbours of every vertex in the order of incident(v), padded with kNone: a step of a walk
/// reads one record of 16 bytes. Entry i of v is its i-th neighbour.
using PaddedNeighbours = UnwrittenVector<std::array<Vertex, 4>>;
PaddedNeighbours padded_neighbours(const Graph& graph, std::uint32_t threads = 1);

/// An orientation of the edges with in- and out-degree at most 2 everywhere, by vertex as bits: bit
/// i of the first or of the second is set if the edge to entry i leaves or enters the vertex.
using BalancedOrientation = std::array<std::vector<std::uint8_t>, 2>;

/// Pairs the entries (0, 1) and (2, 3) of every vertex; the pairs link the edges to trails, and
/// every trail is oriented along itself. So a pair is one edge in and one out, and at most one edge
/// of a vertex is unpaired. Cost: O(n).
BalancedOrientation balanced_orientation(const PaddedNeighbours& neighbours);

enum Colour : unsigned { kGreen = 0, kRed = 1 };

/// By colour c and vertex v: the edge of colour c that leaves v (to == kNone: there is none); every
/// edge is the entry of its tail in its colour, and every vertex has at most one edge of each
/// colour in and one out. So each colour is a set of vertex-disjoint directed paths and cycles.
using TwoColouring = std::array<std::vector<HalfEdge>, 2>;

/// Pairs the two outgoing and the two incoming edges of every vertex and colours the chains so
/// linked alternately. A chain alternates between pairs out and pairs in, so closed ones are even:
/// no parity case arises, unlike in an Euler tour. Cost: O(n + m).
/// @param neighbours  padded_neighbours(graph), of maximum degree at most 4.
TwoColouring two_colouring(const Graph& graph, const PaddedNeighbours& neighbours,
                           const BalancedOrientation& orientation);

}  // namespace ar3d::diamond
