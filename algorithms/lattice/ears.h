#pragma once

#include <cstdint>
#include <limits>
#include <vector>

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

}  // namespace ar3d::lattice
