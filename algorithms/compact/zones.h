#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/compact/narrow.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact {

/// Greedy proper colouring in order of vertex numbers: colours 0 .. max degree.
std::vector<std::uint8_t> greedy_colours(const Graph& graph);

/// The wide strip of the size bound's proof: colour k stands in the columns begin[k] .. begin[k] +
/// width[k] - 1, with rows + 3 empty columns between zones.
struct Zones {
  std::vector<std::int32_t> begin;
  std::vector<std::int32_t> width;  ///< even
  StripSize size;
  std::int32_t cap = 1;  ///< T
};

/// The most cells of a zone with n_k vertices that can be closed to its last vertex, when the graph
/// has n.
std::int64_t most_closed_cells(std::int64_t n_k, std::int64_t n, std::int64_t rows,
                               std::int64_t cap);

/// Zones with one eighth more cells than can ever be closed. @param sizes  vertices by colour, all
/// >= 1.
Zones lay_out_zones(const std::vector<std::int64_t>& sizes);

/// Places every vertex in its zone, whole lines and cap rule: at most 6 log2(n) + 8 random cells
/// each, then all cells in turn, of which one is free. O(n) expected.
/// @param random_trials  false: all cells in turn at once (tests), O(n^2).
Strip fill_zones(const Graph& graph, const Decomposition& links, RandomStream random,
                 Census& census, bool random_trials = true);

}  // namespace ar3d::compact
