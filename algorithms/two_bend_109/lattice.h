#pragma once

#include "ar3d/model/lattice.h"

namespace ar3d::two_bend_109 {

/// Squared length 2x^2 + 6y^2 + z^2: the cube grid seen along (1, 1, 1), times sqrt(3). Here a
/// regular tetrahedron may stand exactly on the z-axis: (0, 0, 3), (2, 0, -1), (-1, 1, -1),
/// (-1, -1, -1).
inline constexpr Lattice kAxisLattice{{{{2, 0, 0}, {0, 6, 0}, {0, 0, 1}}}, 1};

}  // namespace ar3d::two_bend_109
