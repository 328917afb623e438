#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/algorithms/compact/letters.h"
#include "ar3d/algorithms/compact/strip.h"
#include "ar3d/algorithms/strips/search.h"
#include "ar3d/base/random.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact {

using strips::Census;
using strips::Tightness;

/// The strip for n vertices, n <= kMaxVertices: O(sqrt n) rows and columns.
StripSize narrow_size(std::int64_t n, const Tightness& tightness);

/// After so many cells that do not fit a vertex, one of its placed neighbours is ejected.
inline constexpr int kNarrowTrials = 120;

/// Greedy search with ejections: vertices take random cells; after 120 cells that do not fit a
/// vertex, one of its placed neighbours makes room and is placed again later.
/// @return nothing if the ejections do not suffice. Tries O(n + ejections) cells in any case, each
/// in O(1) expected. Draws the numbers of RandomStream(seed, stream).
std::optional<Placement> fill_narrow_strip(const Decomposition& links, std::size_t num_edges,
                                           const Tightness& tightness, std::uint64_t seed,
                                           std::uint64_t stream, Census& census);

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
Placement fill_zones(const Graph& graph, const Decomposition& links, RandomStream random,
                     Census& census, bool random_trials = true);

}  // namespace ar3d::compact
