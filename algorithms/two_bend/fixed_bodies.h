#pragma once

#include <array>
#include <cstdint>

#include "ar3d/algorithms/two_bend/blocks.h"
#include "ar3d/algorithms/two_bend/output.h"

namespace ar3d::two_bend {

/// Holds how far a Q body reaches from its joint: to both sides in its plane, and away from it.
inline constexpr std::int64_t kQHalfWidth = 3;
inline constexpr std::int64_t kQHeight = 9;

/// Holds what every fixed body (K4, K3,3, a Q on its own) and a single vertex keep within.
inline constexpr std::array<std::int64_t, 3> kFixedBodyBound{14, 10, 21};

/// Draws the five vertices of a Q, its joint at `at`: two regular hexagons in a vertical plane.
/// Upwards in the plane x = const (above an END), or downwards in the plane y = const (below a
/// START).
void draw_q_body(const LocalGraph& graph, const QBody& body, Point at, bool upwards,
                 Output& output);

/// Draws K4 or K3,3 from a table. @return false (nothing drawn) if the component is neither.
bool draw_small_cubic(const LocalGraph& graph, Output& output);

}  // namespace ar3d::two_bend
