#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/algorithms/lattice/net.h"
#include "ar3d/model/graph.h"

namespace ar3d::lattice {

/// What a search for an embedding came to.
struct Embedding {
  enum class Outcome {
    found,    ///< `points` has a vertex of the net for every vertex, neighbours at neighbours
    none,     ///< every way was tried: the graph is no part of the net
    given_up  ///< too many tries: not decided
  };
  Outcome outcome = Outcome::given_up;
  std::vector<Point> points;
  std::uint64_t tries = 0;  ///< points that a vertex was tried at
};

/// Searches for a connected graph (n >= 1) as a subgraph of the net, the first vertex at the
/// origin. Cost: O(n) tries, of O(1) expected time each, in pieces whose cycles leave little
/// choice; finding out is NP-hard in general, so the search ends after `most_tries`.
Embedding embed(const Graph& graph, const SpaceNet& net, std::uint64_t most_tries);

}  // namespace ar3d::lattice
