#pragma once

#include <cstdint>
#include <optional>

#include "ar3d/algorithms/compact_120/levels.h"
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
                                       const Tightness& tightness, RandomStream random,
                                       Census& census);

}  // namespace ar3d::compact_120
