#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/algorithms/compact/strip.h"
#include "ar3d/algorithms/strips/search.h"
#include "ar3d/base/random.h"

namespace ar3d::compact {

using strips::Census;
using strips::Tightness;
using strips::widened;

/// The strip for n vertices, n <= kMaxVertices: O(sqrt n) rows and columns.
StripSize narrow_size(std::int64_t n, const Tightness& tightness);

/// After so many cells that do not fit a vertex, a neighbour is ejected.
inline constexpr int kNarrowTrials = 120;
std::int64_t most_ejections(std::int64_t n, const Tightness& tightness);
/// All vertices, the first one last.
std::vector<Vertex> stack_of_vertices(Vertex n);

/// Greedy search with ejections: vertices take random cells; after 120 cells that do not fit a
/// vertex, one of its placed neighbours makes room and is placed again later.
/// @return nothing if the ejections do not suffice. Tries O(n + ejections) cells in any case, each
/// in O(1) expected.
std::optional<Strip> fill_narrow_strip(const Decomposition& links, std::size_t num_edges,
                                       const Tightness& tightness, RandomStream random,
                                       Census& census);

}  // namespace ar3d::compact
