#pragma once

#include <cstdint>
#include <optional>

#include "ar3d/algorithms/compact/strip.h"
#include "ar3d/model/random.h"

namespace ar3d::compact {

/// What a search did.
struct Census {
  std::int64_t trials = 0;     ///< cells tried
  std::int64_t ejections = 0;  ///< vertices taken away again
  std::int64_t scans = 0;      ///< vertices for which all cells were tried in turn
  std::int64_t widenings = 0;  ///< narrow strips given up
};

/// How tight a narrow strip is; ratios in hundredths.
struct Tightness {
  std::int64_t cells = 105;        ///< cells per vertex
  std::int64_t rows = 105;         ///< rows over sqrt(n)
  std::int64_t reach = 60;         ///< reach over columns
  std::int64_t extra_columns = 3;  ///< what small graphs need besides
  std::int64_t extra_reach = 1;
  std::int64_t ejections = 50;  ///< ejections a vertex before the strip counts as too narrow
};

/// The strip for n vertices, n <= kMaxVertices: O(sqrt n) rows and columns.
StripSize narrow_size(std::int64_t n, const Tightness& tightness);

/// The next wider strip: a tenth more cells, and a column.
Tightness widened(Tightness tightness);

/// Greedy search with ejections: vertices take random cells; after 120 cells that do not fit a
/// vertex, one of its placed neighbours makes room and is placed again later.
/// @return nothing if the ejections do not suffice. Tries O(n + ejections) cells in any case, each
/// in O(1) expected.
std::optional<Strip> fill_narrow_strip(const Decomposition& links, std::size_t num_edges,
                                       const Tightness& tightness, RandomStream random,
                                       Census& census);

}  // namespace ar3d::compact
