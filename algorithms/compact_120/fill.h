#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/algorithms/compact_120/order.h"
#include "ar3d/algorithms/compact_120/strip.h"
#include "ar3d/algorithms/strips/search.h"
#include "ar3d/base/random.h"

namespace ar3d::compact_120 {

using strips::Census;
using strips::Tightness;

/// The strip for the vertices of an order: O(sqrt n) rows and columns. A vertex of class N counts
/// 7/5, if that is more than all vertices count.
StripSize narrow_size(const NarrowOrder& order, const Tightness& tightness);

/// Greedy search with ejections: vertices take random cells among those to which their placed
/// neighbours leave positive lengths; after some cells that do not fit, one placed neighbour makes
/// room and is placed again later.
/// @return nothing if the ejections do not suffice. Tries O(n + ejections) cells in any case, each
/// in O(1) expected.
std::optional<Strip> fill_narrow_strip(const NarrowOrder& order, std::size_t num_edges,
                                       const Tightness& tightness, strips::NumbersAhead random,
                                       Census& census);

/// The wide strip of the size bound's proof: level k stands in the columns begin[k] .. begin[k] +
/// width[k] - 1, with enough empty columns between zones that all lengths are at least 1.
struct Zones {
  std::vector<std::int32_t> begin;
  std::vector<std::int32_t> width;
  StripSize size;
};

/// The most cells of a zone with n_k vertices that can be closed to its last vertex.
std::int64_t most_closed_cells(std::int64_t n_k, std::int64_t rows);

/// Zones with one eighth more cells than can ever be closed. @param sizes  vertices by level, all
/// >= 1.
Zones lay_out_zones(const std::vector<std::int64_t>& sizes);

/// Places every vertex in the zone of its level, whole lines: at most 6 log2(n) + 8 random cells
/// each, then all cells in turn, of which one is free. O(n) expected.
/// @param levels  of in_levels; links made with the same order.
/// @param random_trials  false: all cells in turn at once (tests), O(n^2).
Strip fill_zones(const Order& levels, const Links& links, std::size_t num_edges,
                 RandomStream random, Census& census, bool random_trials = true);

}  // namespace ar3d::compact_120
