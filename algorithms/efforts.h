#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d {

__extension__ using Volume = unsigned __int128;

/// Number of lattice points of a box. It does not wrap: of all proved boxes that are compared, the
/// largest is that of two-bend-109 with kMostCompared vertices, and below 2^104.
inline Volume volume_of(const std::array<std::int64_t, 3>& extents) {
  Volume product = 1;
  for (const std::int64_t extent : extents) product *= static_cast<Volume>(extent + 1);
  return product;
}

/// Up to so many vertices no effort draws a larger box than a lower one: what that draws is kept
/// where it is smaller. Beyond, two drawings would take too much time and memory.
inline constexpr std::uint64_t kMostCompared = 5000;

/// The smallest drawing of this effort and the lower ones, of equal ones that of the highest; of
/// graphs with more than kMostCompared vertices that of this effort. Cost: the drawings' and their
/// boxes'.
template <class Options>
Drawing smallest_of_efforts(const Graph& graph, Options options,
                            Drawing (*draw)(const Graph&, const Options&)) {
  Drawing best = draw(graph, options);
  if (graph.num_vertices() > kMostCompared) return best;
  while (options.effort-- > 0) {
    Drawing other = draw(graph, options);
    if (volume_of(bounding_box(other).extents()) < volume_of(bounding_box(best).extents())) {
      best = std::move(other);
    }
  }
  return best;
}

}  // namespace ar3d
