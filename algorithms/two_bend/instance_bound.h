#pragma once

#include <array>
#include <cstdint>

#include "ar3d/algorithms/two_bend/layout.h"

namespace ar3d::two_bend {

/// Extents that the proof promises for this very input, from the numbers of its parts and the
/// distances in its lists, not from the drawing (docs/theorem2.md, "Extents").
struct InstanceBound {
  std::array<std::int64_t, 3> extents{};

  /// Components are stacked in z.
  void add(const std::array<std::int64_t, 3>& component);
};

/// @param places  vertices in the time order; @param bodies  Q bodies.
std::array<std::int64_t, 3> bound_component(const Flow& flow, const Layout& layout,
                                            std::size_t places, std::size_t bodies);

/// What every fixed body (K4, K3,3, a Q on its own) and a single vertex keep within.
inline constexpr std::array<std::int64_t, 3> kFixedBodyBound{14, 10, 21};

}  // namespace ar3d::two_bend
