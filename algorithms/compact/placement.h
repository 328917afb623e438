#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/compact/letters.h"
#include "ar3d/base/threads.h"

namespace ar3d::compact {

/// The cells (i, j), 0 <= i < columns, 0 <= j < rows, i = j mod 2.
struct StripSize {
  std::int32_t columns = 1;
  std::int32_t rows = 1;
  std::int32_t reach = 1;  ///< an edge spans at most this many columns
  friend bool operator==(const StripSize&, const StripSize&) = default;
};

/// A filled strip: what a drawing is made of.
struct Placement {
  StripSize size;
  UnwrittenVector<Place> places;      ///< by vertex
  std::vector<std::uint8_t> variant;  ///< by edge: in which of its words it is routed
};

}  // namespace ar3d::compact
