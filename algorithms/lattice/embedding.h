#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "ar3d/algorithms/lattice/net.h"
#include "ar3d/model/graph.h"

namespace ar3d::lattice {

inline constexpr std::uint32_t kNoStep = std::numeric_limits<std::uint32_t>::max();

/// The next vertex of a connected graph to be placed. Steps are numbered from 0.
struct EarStep {
  Vertex vertex = 0;
  std::uint32_t from = kNoStep;    ///< step of a neighbour before it; kNoStep of the first alone
  std::uint32_t target = kNoStep;  ///< step at the end of its ear; kNoStep if it lies on none
  std::uint32_t left = 0;          ///< edges from here to that end
};

/// The vertices of a connected graph (n >= 1) in the order of an ear decomposition that takes the
/// shortest ear it finds next; what lies on no cycle comes last. Cost: O(m log m) in pieces of
/// lattices, whose ears are short; O(n m) at worst.
std::vector<EarStep> ear_order(const Graph& graph);

/// Holds what a search for an embedding came to.
struct Embedding {
  bool is_given_up = false;   ///< too many tries: not decided
  std::vector<Point> points;  ///< a vertex of the net for every vertex, neighbours at neighbours;
                              ///< none if every way was tried: the graph is no part of the net
  std::uint64_t tries = 0;    ///< points that a vertex was tried at
};

/// Searches for a connected graph (n >= 1) as a subgraph of the net, the first vertex at the
/// origin. Cost: O(n) tries, of O(1) expected time each, in pieces whose cycles leave little
/// choice; finding out is NP-hard in general, so the search ends after `most_tries`.
Embedding embed(const Graph& graph, const SpaceNet& net, std::uint64_t most_tries);

}  // namespace ar3d::lattice
